package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.concurrent.atomic.AtomicReference;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.FakeBot;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.drivertest.TestClock;
import majic.time.Signal;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class BotDriverTest {
    @AutoClose
    private final SteppedBot stepped = new SteppedBot();

    private final TestClock clock = stepped.clock;
    private final FakeBot bot = stepped.bot;

    @Test
    void connectingSendsNothingThatMoves() {
        assertThat(bot.sent()).isEmpty();
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void moveReturnsWhenTheRobotIsStationaryAgain() {
        MotionReport report = bot.move(600);

        assertThat(report).hasToString("600 mm, 2.0 s");
        assertThat(bot.state().moving()).isFalse();
    }

    @Test
    void aGuardEndsAMoveEarly() {
        bot.putObstacle(1000);

        MotionReport report = bot.move(2000, () -> bot.get("distanceFront").number() < 500);

        assertThat(report.amount()).isEqualTo(Value.of(510, Unit.MM));
    }

    @Test
    void aTimedDriveThatStoodStillDoesNotGoOn() {
        Guard slow = () -> {
            if (bot.sent().contains("drive 100 0")) {
                standStill(3);
            }
            return false;
        };
        clock.time().thread("reading", () -> read(1)).start();

        assertThatThrownBy(() -> bot.drive(100, 0, 40, slow))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("stood still for 3 s");
        assertThat(bot.sent().stream().filter("halt"::equals)).hasSize(1);
        assertThat(bot.sent()).endsWith("halt");
    }

    private void read(double afterSeconds) {
        standStill(afterSeconds);
        bot.tell("voltage", Value.of(12, Unit.V));
    }

    private void standStill(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aGuardThatCannotBeEvaluatedFailsTheMoveAndHalts() {
        assertThatThrownBy(() -> bot.move(500, () -> {
                    throw new BotException("sonar: no reading yet");
                }))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("sonar: no reading yet");
        assertThat(bot.sent()).endsWith("halt");
    }

    @Test
    void aStopEndsAMoveOfAnotherThread() throws InterruptedException {
        AtomicReference<BotException> thrown = new AtomicReference<>();
        Signal done = clock.time().signal();
        Thread mover = clock.time().thread("mover", () -> {
            try {
                bot.move(5000);
            } catch (BotException e) {
                thrown.set(e);
            }
            done.raise();
        });
        mover.start();
        clock.time().sleep(1);

        bot.stop();

        assertThat(done.await(() -> thrown.get() != null, 1)).isTrue();
        assertThat(thrown.get()).isInstanceOf(MotionStopped.class);
        assertThat(bot.sent()).endsWith("halt");
    }

    @Test
    void nothingBegunBeforeAStopCanMoveTheRobotAfterIt() {
        BotDriver driver = bot;
        Permit before = driver.permit();

        driver.stop();

        assertThatThrownBy(() -> driver.move(100, Guard.NEVER, before)).isInstanceOf(MotionStopped.class);
        assertThat(bot.sent()).containsOnly("halt");
    }

    @Test
    void aDriveThatIsNotRenewedEndsAfter600Ms() throws InterruptedException {
        bot.drive(200, 0);
        clock.time().sleep(0.5);
        assertThat(bot.sent()).containsExactly("drive 200 0");

        clock.time().sleep(0.2);

        assertThat(bot.sent()).containsExactly("drive 200 0", "halt");
    }

    @Test
    void aRenewedDriveGoesOn() throws InterruptedException {
        for (int renewal = 0; renewal < 5; renewal++) {
            bot.drive(200, 0);
            clock.time().sleep(0.4);
        }

        assertThat(bot.sent()).doesNotContain("halt");
    }

    @Test
    void aTimedDriveLastsItsTime() {
        MotionReport report = bot.drive(200, 30, 1, Guard.NEVER);

        assertThat(report.seconds()).isBetween(1.0, 1.02);
        assertThat(bot.sent()).startsWith("drive 200 30").endsWith("halt");
    }

    @Test
    void aTimedDriveIsDoneWhenTheRobotHasConfirmedItsStop() {
        bot.standAfter(0.4);

        MotionReport report = bot.drive(200, 30, 1, Guard.NEVER);

        assertThat(report.seconds()).isBetween(1.4, 1.42);
        assertThat(bot.sent()).endsWith("halt", "stands");
    }

    @Test
    void aStopWhileATimedDriveBrakesEndsItAsStopped() {
        bot.standAfter(0.4);
        bot.getStuck();
        clock.time()
                .thread("stopper", () -> {
                    pause(1.2);
                    bot.revokeMotions();
                    bot.writeStop();
                })
                .start();

        assertThatThrownBy(() -> bot.drive(200, 30, 1, Guard.NEVER)).isInstanceOf(MotionStopped.class);
    }

    @Test
    void aLostLinkEndsAMoveWithItsCause() throws InterruptedException {
        clock.time()
                .thread("cutter", () -> {
                    pause(0.5);
                    bot.cut();
                })
                .start();

        assertThatThrownBy(() -> bot.move(5000)).isInstanceOf(LinkLost.class).hasMessage("connection lost");
        assertThatThrownBy(() -> bot.turn(90)).isInstanceOf(LinkLost.class);
    }

    private void pause(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void motionsOfTwoCallersFollowOneAnother() throws InterruptedException {
        Signal done = clock.time().signal();
        AtomicReference<MotionReport> other = new AtomicReference<>();
        clock.time()
                .thread("other", () -> {
                    other.set(bot.move(300));
                    done.raise();
                })
                .start();
        clock.time().sleep(0.1);

        bot.turn(90);

        assertThat(other.get()).isNotNull();
        assertThat(bot.sent()).containsExactly("move 300", "turn 90");
    }

    @Test
    void aMoveBeyondMaxMoveIsRefused() {
        assertThatThrownBy(() -> bot.move(6000))
                .isInstanceOf(ParameterException.class)
                .hasMessage("move 6000: longer than maxMove, 5000 mm; set maxMove higher to allow it");
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aWrongParameterIsNamedWithASuggestion() {
        assertThatThrownBy(() -> bot.get("headPam"))
                .hasMessage("headPam: the Fake has no such parameter; did you mean headPan?");
    }

    @Test
    void aValueOutsideItsRangeIsRefused() {
        assertThatThrownBy(() -> bot.set("headPan", 120)).hasMessage("headPan 120: outside -91 … 91 deg");
    }

    @Test
    void aLatchedRobotRefusesMotionAndMovingSettingsButNotReading() {
        bot.latch();

        assertThatThrownBy(() -> bot.move(100)).hasMessageContaining("STOP is latched");
        assertThatThrownBy(() -> bot.set("headPan", 10)).hasMessageContaining("STOP is latched");
        assertThatThrownBy(() -> bot.drive(100, 0)).hasMessageContaining("STOP is latched");
        assertThat(bot.get("voltage")).hasToString("12.6 V");
    }

    @Test
    void aDriveEndsForAMotionEvenIfThatHasNothingToDo() throws InterruptedException {
        bot.drive(200, 0);

        bot.turn(0, () -> true);
        clock.time().sleep(1);

        assertThat(bot.sent()).startsWith("drive 200 0", "halt").doesNotHaveDuplicates();
    }

    @Test
    void anErrorInAGuardHaltsTheRobotToo() {
        assertThatThrownBy(() -> bot.move(500, () -> {
                    throw new StackOverflowError();
                }))
                .isInstanceOf(StackOverflowError.class);
        assertThat(bot.sent()).endsWith("halt");
    }

    @Test
    void aDriverThatFailsWhileConnectingMayTryAgain() {
        FakeBot other = FakeBot.on(clock.time());
        other.breakDownWhileConnecting(new IllegalStateException("a mistake of the driver"));
        assertThatThrownBy(other::connect).isInstanceOf(IllegalStateException.class);

        other.breakDownWhileConnecting(null);
        other.connect();

        assertThat(other.isConnected()).isTrue();
        other.close();
    }

    @Test
    void anAttemptToConnectThatWasLostEndsBeforeTheNextOneBegins() throws InterruptedException {
        FakeBot other = FakeBot.on(clock.time());
        other.connectIn(2);
        AtomicReference<String> first = new AtomicReference<>();
        clock.time()
                .runAsync(
                        "first attempt",
                        () -> first.set(catchThrowable(other::connect).getMessage()));
        clock.time().sleep(1);
        other.cut();

        assertThatThrownBy(other::connect).hasMessage("the Fake is already connecting");

        clock.time().sleep(1.5);
        assertThat(first).hasValue("connection lost");
        other.connect();
        assertThat(other.isConnected()).isTrue();
        other.close();
    }

    @Test
    void keepsWhatWasSetWhenItsProfileChanges() {
        bot.set("cruise", 400);

        bot.profile(new BotProfile(150, new Range(-350, 350), new Range(-90, 90), 200, 45, 300, false));

        assertThat(bot.get("cruise").number()).isEqualTo(350);
        assertThat(bot.get("cruiseTurn").number()).isEqualTo(45);
        assertThat(bot.get("near").number()).isEqualTo(300);
        assertThatThrownBy(() -> bot.set("cruise", 400)).hasMessage("cruise 400: outside 1 … 350 mm/s");
    }

    @Test
    void describesAnewWhatDependsOnTheRobotFound() {
        bot.table().renew(table -> {
            describe(table, "arm");
            describe(table, "leg");
        });
        bot.table().renew(table -> describe(table, "leg"));

        assertThat(bot.get("leg")).hasToString("bent");
        assertThatThrownBy(() -> bot.get("arm")).hasMessageStartingWith("arm: the Fake has no such parameter");
    }

    private static void describe(ParameterTable table, String name) {
        table.add(Parameter.text(name, "a limb"), () -> Value.text("bent"));
    }

    @Test
    void aSpeedThatIsNoNumberIsRefusedInWords() {
        assertThatThrownBy(() -> bot.drive(Double.NaN, 0))
                .isInstanceOf(ParameterException.class)
                .hasMessageContaining("drive NaN: outside");
    }
}
