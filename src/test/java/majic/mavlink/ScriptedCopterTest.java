package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.Course;
import majic.bot.Guard;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** What a copter is sent, and what is not sent to it. */
class ScriptedCopterTest {
    private static final int GUIDED = 4;
    private static final int LAND = 9;
    private static final int BRAKE = 17;
    private static final int ARM = 400;

    @AutoClose
    private final DrivenRover robot = new DrivenRover();

    private final ScriptedRover copter = robot.rover;
    private final MajicMavlink bot = robot.bot();

    ScriptedCopterTest() {
        copter.type = 2;
    }

    private void fence(double radiusMm, double lowestMm, double highestMm) {
        bot.set(
                "fence",
                List.of(Value.of(radiusMm, Unit.MM), Value.of(lowestMm, Unit.MM), Value.of(highestMm, Unit.MM)));
    }

    private void flying() {
        bot.connect();
        fence(10_000, 500, 5000);
        robot.pass(1.2);
        bot.run("arm", List.of());
        bot.run("takeoff", List.of(Value.of(2000, Unit.MM)));
    }

    @Test
    void connectingAsksForItsHeightAndSetsNothing() {
        bot.connect();
        robot.pass(1);

        assertThat(copter.commands(511)).anyMatch(got -> got.f32(0) == 245);
        assertThat(copter.commands(ARM)).isEmpty();
        assertThat(copter.commands(176)).isEmpty();
    }

    /** It is not sent without a request. */
    @Test
    void itsStateOnTheGroundIsAskedForAgainWhenTheRequestWasLost() {
        copter.lostRequest = 245;
        bot.connect();
        robot.pass(4);

        bot.run("arm", List.of());

        assertThat(copter.armed).isTrue();
    }

    @Test
    void aCopterThatDoesNotKnowItsStateOnTheGroundIsNotAskedForEver() {
        copter.withoutLandedState = true;
        bot.connect();
        robot.pass(120);

        assertThat(copter.commands(511)).filteredOn(got -> got.f32(0) == 245).hasSizeLessThan(10);
    }

    @Test
    void withoutAFenceEveryMotionIsRefusedWithHowToSetOne() {
        bot.connect();
        robot.pass(1.2);
        bot.run("arm", List.of());
        int before = copter.received.size();

        for (String motion : List.of("takeoff", "climb")) {
            assertThatThrownBy(() -> bot.run(motion, List.of(Value.of(1000, Unit.MM))))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageContaining("set fence RADIUS LOWEST HIGHEST");
        }
        assertThatThrownBy(() -> bot.move(1000)).hasMessageContaining("set fence RADIUS LOWEST HIGHEST");
        assertThatThrownBy(() -> bot.turn(90)).hasMessageContaining("set fence RADIUS LOWEST HIGHEST");
        assertThatThrownBy(() -> bot.drive(100, 0)).hasMessageContaining("set fence RADIUS LOWEST HIGHEST");
        assertThat(copter.received.subList(before, copter.received.size()))
                .noneMatch(got -> got.id() == 84 && got.f32(16) != 0)
                .noneMatch(got -> got.id() == 76 && got.u16(28) == 22);
    }

    @Test
    void aMotionNeverArmsIt() {
        bot.connect();
        fence(10_000, 500, 5000);
        bot.set("armByMotion", "on");
        robot.pass(1.2);

        assertThatThrownBy(() -> bot.run("takeoff", List.of(Value.of(1000, Unit.MM))))
                .hasMessageContaining("it is not armed");
        assertThatThrownBy(() -> bot.move(1000)).hasMessageContaining("it is not armed");
        assertThat(copter.commands(ARM)).isEmpty();
    }

    @Test
    void oneThatAnotherHasArmedIsNotFlown() {
        copter.armed = true;
        copter.landed = 2;
        bot.connect();
        fence(10_000, 0, 5000);
        robot.pass(1.2);

        assertThatThrownBy(() -> bot.move(1000)).hasMessageContaining("it was not armed by \"arm\" of this connection");
        assertThatThrownBy(() -> bot.run("arm", List.of())).hasMessageContaining("it was armed by another");
        assertThat(copter.commands(ARM)).isEmpty();
    }

    @Test
    void takeOffIsSentWithItsHeightInMetresInGuided() {
        flying();

        VehicleFrames.Got sent = copter.commands(22).get(0);
        assertThat(sent.f32(24)).isEqualTo(2f);
        assertThat(copter.mode).isEqualTo(GUIDED);
    }

    @Test
    void onTheGroundItIsNotBelowItsFence() {
        bot.connect();
        fence(10_000, 1500, 5000);
        robot.pass(1.2);
        bot.run("arm", List.of());
        robot.pass(3);
        copter.ignoresModes = true;
        copter.changeMode(BRAKE);
        robot.pass(0.1);
        CompletableFuture<?> takeOff = robot.clock().aside(() -> bot.run("takeoff", List.of(Value.of(2000, Unit.MM))));
        robot.pass(1);
        copter.ignoresModes = false;

        robot.clock().join(takeOff);
        assertThat(copter.heightMm).isEqualTo(2000);
        assertThat(copter.commands(176)).noneMatch(got -> got.f32(4) == BRAKE);
    }

    @Test
    void aClimbThatWasHeldUpDoesNotGoOn() {
        flying();
        AtomicBoolean held = new AtomicBoolean();
        Guard stuck = () -> {
            if (copter.heightMm > 2500 && held.compareAndSet(false, true)) {
                robot.pass(5);
            }
            return false;
        };
        CompletableFuture<String> climb =
                robot.clock().aside(() -> bot.run("climb", List.of(Value.of(2000, Unit.MM)), stuck));
        robot.clock().until(() -> held.get() || climb.isDone());
        robot.pass(4.5);
        double stoppedMm = copter.heightMm;

        assertThatThrownBy(() -> robot.clock().join(climb))
                .hasCauseInstanceOf(MotionFailed.class)
                .hasMessageContaining("this program stood still for 5 s after");
        robot.pass(2);

        assertThat(copter.heightMm).isEqualTo(stoppedMm);
    }

    @Test
    void velocitiesHaveTheMaskOfACopterAndDownIsPositive() {
        flying();

        bot.run("climb", List.of(Value.of(1000, Unit.MM)));

        assertThat(copter.heightMm).isCloseTo(3000, within(150.0));
        assertThat(copter.targets()).allMatch(got -> got.u16(48) == 0x05C7 && got.u8(52) == 8);
        assertThat(copter.targets()).anyMatch(got -> got.f32(24) < -0.3);
        assertThat(copter.targets()).last().matches(got -> got.f32(24) == 0);
    }

    @Test
    void aStopIsBrakeThenAZeroVelocityAndNothingDisarms() {
        flying();
        CompletableFuture<?> motion = robot.clock().aside(() -> bot.move(5000));
        robot.clock().until(() -> copter.mmPerSec() > 300 || motion.isDone());
        int before = copter.received.size();

        bot.stop();

        List<VehicleFrames.Got> sent = copter.received.subList(before, copter.received.size());
        assertThat(sent.get(0).u16(28)).isEqualTo(176);
        assertThat(sent.get(0).f32(4)).isEqualTo(BRAKE);
        assertThat(sent.get(1).id()).isEqualTo(84);
        assertThat(sent).filteredOn(got -> got.id() == 84).allMatch(got -> got.f32(16) == 0 && got.f32(24) == 0);
        assertThat(copter.commands(ARM)).hasSize(1);
        assertThat(copter.armed).isTrue();
    }

    /** A watchdog of the autopilot restarts it in the air; it arms itself again. */
    @Test
    void oneWhoseAutopilotHasRestartedInTheAirIsNotFlownOn() {
        flying();
        copter.restart();
        copter.armed = true;
        copter.mode = GUIDED;
        robot.pass(3);
        int before = copter.targets().size();

        assertThatThrownBy(() -> bot.move(1000)).hasMessageContaining("it was not armed by \"arm\" of this connection");
        assertThat(copter.targets()).hasSize(before);
    }

    @Test
    void inTheAirNoDisarmIsSent() {
        flying();

        assertThatThrownBy(() -> bot.run("disarm", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("does not report that it is on the ground");
        assertThat(copter.commands(ARM)).hasSize(1);
        copter.landed = 1;
        robot.pass(1);
        bot.run("disarm", List.of());
        assertThat(copter.armed).isFalse();
    }

    @Test
    void theFailsafeOfItsBatteryEndsAMotionAndMajicSetsNoMode() {
        flying();
        CompletableFuture<?> motion = robot.clock().aside(() -> bot.move(5000));
        robot.clock().until(() -> copter.mmPerSec() > 300 || motion.isDone());
        int before = copter.commands(176).size();

        copter.text("Battery Failsafe");

        assertThatThrownBy(() -> robot.clock().join(motion)).hasMessageContaining("Battery Failsafe");
        assertThat(copter.commands(176)).hasSize(before);
    }

    @Test
    void theFailsafeOfItsBatteryEndsACourseThatStands() {
        flying();
        long beganMs = robot.peer.millis();
        AtomicBoolean failed = new AtomicBoolean();
        Course course = () -> {
            long passedMs = robot.peer.millis() - beganMs;
            if (passedMs > 3000 && failed.compareAndSet(false, true)) {
                copter.text("Battery Failsafe");
                copter.changeMode(LAND);
            }
            return passedMs < 1500 || passedMs > 4500 ? new Course.Drive(300, 0) : Course.Drive.STAND;
        };
        CompletableFuture<?> motion = robot.clock().aside(() -> bot.follow(course, Guard.NEVER));
        robot.clock().until(() -> copter.mode == LAND || motion.isDone());

        assertThatThrownBy(() -> robot.clock().join(motion)).hasMessageContaining("Battery Failsafe");
        robot.pass(2);
        assertThat(copter.mode).isEqualTo(LAND);
    }

    @Test
    void aLostPositionEndsAMotionAfterASecond() {
        flying();
        CompletableFuture<?> motion = robot.clock().aside(() -> bot.move(5000));
        robot.clock().until(() -> copter.mmPerSec() > 300 || motion.isDone());
        long from = robot.peer.millis();

        copter.positionless = true;

        assertThatThrownBy(() -> robot.clock().join(motion)).isNotNull();
        assertThat(copter.targets()).last().matches(got -> got.f32(16) == 0);
        assertThat(robot.peer.millis() - from).isLessThan(8000);
    }
}
