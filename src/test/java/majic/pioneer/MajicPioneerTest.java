package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import majic.TestClock;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Settings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver against a peer on loopback, in real time. */
@Timeout(30)
class MajicPioneerTest {
    private Peer peer;
    private MajicPioneer bot;
    private final List<String> notices = new CopyOnWriteArrayList<>();

    @AfterEach
    void closeAll() throws IOException {
        bot.close();
        peer.close();
    }

    @Test
    void connectingSwitchesNoMotorsOnAndMovesNothing() throws Exception {
        connect(Peer.Quirk.NONE);

        assertThat(peer.hears("SONAR 1")).isTrue();
        assertThat(peer.heard()).startsWith("OPEN 1", "CONFIG 1");
        assertThat(peer.heard()).noneMatch(command -> command.matches("(ENABLE|VEL|RVEL|MOVE|HEAD).*"));
        assertThat(bot.get("motors")).hasToString("no");
        assertThat(bot.get("model")).hasToString("p3dx-sh");
        assertThat(bot.get("firmware")).hasToString("S.0");
    }

    @Test
    void moveSwitchesMotorsOnAndArrives() throws IOException {
        connect(Peer.Quirk.NONE);

        MotionReport report = bot.move(150);

        assertThat(number(report)).isCloseTo(150, within(10.0));
        assertThat(bot.state().pose().xMm()).isCloseTo(150, within(10.0));
        assertThat(bot.state().speedMmPerSec()).isZero();
        assertThat(notices).containsOnlyOnce("motors on");
    }

    @Test
    void turnArrivesOnTheRight() throws IOException {
        connect(Peer.Quirk.NO_CONFIG);

        assertThat(number(bot.turn(-30))).isCloseTo(-30, within(1.0));
    }

    @Test
    void aSessionLeftOpenIsStoppedForGoodBeforeTheHandshake() throws IOException {
        connect(Peer.Quirk.IN_OPEN_SESSION);

        assertThat(peer.heard()).startsWith("ESTOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1", "OPEN 1");
    }

    @Test
    void aRobotThatLosesStepOfTheHandshakeIsStartedOver() throws IOException {
        connect(Peer.Quirk.LOSES_STEP_ONCE);

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aSyncWithoutAnswerIsRepeated() throws IOException {
        connect(Peer.Quirk.DEAF_TO_FIRST_SYNC);

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aPeerThatNeverAnswersIsGivenUp() {
        try (TestClock clock = new TestClock()) {
            BotEnvironment quick = new BotEnvironment(clock.time(), Settings.inMemory());

            assertThatThrownBy(() -> connect(Peer.Quirk.NEVER_ANSWERS, quick))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("no Pioneer answers")
                    .hasMessageContaining("6 s");
        }
        assertThat(bot.connection()).isEqualTo(MajicBot.Connection.LOST);
    }

    @Test
    void aPeerThatHangsUpInTheHandshakeIsSaidToBeTaken() {
        assertThatThrownBy(() -> connect(Peer.Quirk.HANGS_UP)).hasMessageContaining("one program at a time");
    }

    @Test
    void aStallEndsTheMotionWithTheWayCovered() throws Exception {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::stall));

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageMatching("stalled after \\d+(\\.\\d)? mm");
        assertThat(peer.hearsLast("STOP 0", "VEL 0", "RVEL 0")).isTrue();
    }

    @Test
    void theStopButtonEndsTheMotion() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::pressStopButton));

        assertThatThrownBy(() -> bot.move(1000)).hasMessageStartingWith("STOP button pressed after");
    }

    @Test
    void aSilentRobotIsToldToStandAndThenGivenUp() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::fallSilent));

        assertThatThrownBy(() -> bot.move(1000)).hasMessage("connection lost: the robot has been silent for 1 s");

        List<String> heard = peer.heard();
        assertThat(heard.subList(heard.size() - 2, heard.size())).containsExactly("VEL 0", "RVEL 0");
    }

    @Test
    void aRobotThatHangsUpIsLostAtOnceAndCanBeConnectedAgain() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, this::hangUp));

        assertThatThrownBy(() -> bot.move(1000)).hasMessageStartingWith("connection lost");
        bot.connect();

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aGuardEndsTheMotionAtTheReadingThatShowsIt() throws Exception {
        connect(Peer.Quirk.NONE);

        double covered = number(bot.move(1000, () -> bot.state().pose().xMm() > 60));

        assertThat(covered).isBetween(60.0, 200.0);
        assertThat(bot.state().speedMmPerSec()).isZero();
        assertThat(peer.hearsLast("STOP 0", "VEL 0", "RVEL 0")).isTrue();
    }

    @Test
    void aGuardThatHoldsAlreadyLeavesTheMotorsOff() throws IOException {
        connect(Peer.Quirk.NONE);

        assertThat(number(bot.move(1000, () -> true))).isZero();
        assertThat(peer.heard()).noneMatch(command -> command.startsWith("ENABLE"));
    }

    @Test
    void stopEndsAMotionAndReturnsWhenTheRobotStands() throws IOException {
        connect(Peer.Quirk.NONE);
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Thread mover = new Thread(() -> {
            try {
                bot.move(1000);
            } catch (BotException e) {
                failure.set(e);
            }
        });
        bot.addListener(whenBeyond(50, new Thread(bot::stop)::start));

        mover.start();
        join(mover);

        assertThat(failure.get()).isInstanceOf(MotionStopped.class).hasMessage("stopped");
        bot.stop();
        assertThat(bot.state().speedMmPerSec()).isZero();
    }

    @Test
    void aRobotThatStandsSilentIsGivenUpLater() throws Exception {
        connect(Peer.Quirk.NONE);
        CountDownLatch lost = new CountDownLatch(1);
        bot.addListener(new BotListener() {
            @Override
            public void connectionChanged(MajicBot from, MajicBot.Connection now) {
                lost.countDown();
            }
        });
        peer.fallSilent();

        assertThat(lost.await(5, TimeUnit.SECONDS)).isTrue();
        assertThat(bot.connection()).isEqualTo(MajicBot.Connection.LOST);
    }

    @Test
    void pulsesKeepComingWhileNothingElseIsSent() throws Exception {
        connect(Peer.Quirk.NONE);

        assertThat(peer.hears("PULSE 0")).isTrue();
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void closingStopsSwitchesOffAndSaysGoodBye() throws Exception {
        connect(Peer.Quirk.NONE);
        bot.drive(100, 0);

        bot.close();

        assertThat(peer.hearsLast("STOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1"))
                .isTrue();
    }

    private void hangUp() {
        try {
            peer.hangUp();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static BotListener whenBeyond(double mm, Runnable event) {
        return new BotListener() {
            @Override
            public void stateChanged(MajicBot moving, BotState state) {
                if (state.pose().xMm() > mm) {
                    moving.removeListener(this);
                    event.run();
                }
            }
        };
    }

    private void connect(Peer.Quirk quirk) throws IOException {
        connect(quirk, BotEnvironment.plain());
    }

    private void connect(Peer.Quirk quirk, BotEnvironment environment) throws IOException {
        peer = new Peer(quirk);
        bot = new MajicPioneer(peer.address(), environment);
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
        bot.connect();
    }

    private static double number(MotionReport report) {
        return report.amount() == null ? Double.NaN : report.amount().number();
    }

    @Test
    void aMoveThatEndsAStepShortLeavesNoSpeedInForce() throws Exception {
        connect(Peer.Quirk.STICKS_WHEN_SLOW);

        bot.move(150);

        assertThat(peer.hearsLast("STOP 0", "VEL 0", "RVEL 0")).isTrue();
    }
}
