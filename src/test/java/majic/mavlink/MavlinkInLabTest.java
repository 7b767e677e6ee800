package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majicsim.LabOptions;
import majicsim.mavlink.MavlinkOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The driver with the vehicles of the simulated lab, which use no code of the driver. */
class MavlinkInLabTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int BRAKE = 17;

    private static LabRobot connected(String vehicle) {
        LabRobot robot = new LabRobot("mavlink", LabRig.exactWithMavlink(vehicle)).at(1200, 0, 0);
        robot.bot().connect();
        return robot;
    }

    private static LabRobot armed(String vehicle) {
        LabRobot robot = connected(vehicle);
        robot.bot().run("arm", List.of());
        return robot;
    }

    private static void pass(LabRobot robot, double seconds) {
        try {
            robot.bot().time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private static CompletableFuture<MotionReport> aside(LabRobot robot, double mm) {
        CompletableFuture<MotionReport> motion = new CompletableFuture<>();
        robot.bot()
                .time()
                .thread("move", () -> motion.completeAsync(() -> robot.bot().move(mm), Runnable::run))
                .start();
        return motion;
    }

    private static int mode(LabRobot robot) {
        int[] mode = new int[1];
        robot.besideMavlink(vehicle -> mode[0] = vehicle.mode());
        return mode[0];
    }

    @Test
    void aRoverGoesAndTurnsAsItIsTold() {
        try (LabRobot robot = armed("rover+ready")) {
            robot.bot().move(1500);
            robot.bot().turn(90);
            robot.bot().move(500);

            assertThat(robot.truePose().xMm()).isCloseTo(2700, within(150.0));
            assertThat(robot.truePose().yMm()).isCloseTo(500, within(150.0));
            assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(4.0));
        }
    }

    /** The position of the satellites wanders meanwhile, as that of a real vehicle. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aRoverWithAWanderingPositionStandsAndGoesAsItIsTold(long seed) {
        LabRig noisy = LabRig.of(
                LabOptions.exactOnFreePorts().withNoise(seed).withMavlink(MavlinkOptions.parse("rover+ready")));
        try (LabRobot robot = new LabRobot("mavlink", noisy).at(1200, 0, 0)) {
            robot.bot().connect();
            pass(robot, 10);
            assertThat(robot.bot().state().moving()).isFalse();

            robot.bot().run("arm", List.of());
            robot.bot().move(1000);
            robot.bot().turn(90);

            assertThat(robot.truePose().xMm()).isCloseTo(2200, within(400.0));
            assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(5.0));
        }
    }

    @Test
    void aRoverOfMavlink1DoesTheSame() {
        try (LabRobot robot = armed("rover+ready+v1")) {
            robot.bot().move(1000);

            assertThat(robot.truePose().xMm()).isCloseTo(2200, within(150.0));
        }
    }

    @Test
    void aStopHoldsItAtOnce() {
        try (LabRobot robot = armed("rover+ready")) {
            CompletableFuture<MotionReport> motion = aside(robot, 2500);
            pass(robot, 2);

            robot.bot().stop();

            assertThat(mode(robot)).isEqualTo(HOLD);
            double xMm = robot.truePose().xMm();
            pass(robot, 2);
            assertThat(robot.truePose().xMm()).isCloseTo(xMm, within(5.0));
            assertThat(motion).isCompletedExceptionally();
        }
    }

    @Test
    void theRadioPilotTakesItOver() {
        try (LabRobot robot = armed("rover+ready")) {
            CompletableFuture<MotionReport> motion = aside(robot, 2500);
            pass(robot, 2.5);

            robot.besideMavlink(vehicle -> vehicle.pilotMode(MANUAL));
            pass(robot, 8);

            assertThat(motion)
                    .failsWithin(Duration.ZERO)
                    .withThrowableThat()
                    .withCauseInstanceOf(MotionFailed.class)
                    .withMessageContaining("the mode was changed to MANUAL by another");
            assertThat(mode(robot)).isEqualTo(MANUAL);
        }
    }

    @Test
    void aRoverThatHasJustStartedRefusesToArmWithItsReasons() {
        try (LabRobot robot = connected("rover")) {
            assertThatThrownBy(() -> robot.bot().run("arm", List.of()))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageContaining("Arm: ");

            pass(robot, 50);
            robot.bot().run("arm", List.of());
            robot.bot().move(500);
            assertThat(robot.truePose().xMm()).isCloseTo(1700, within(150.0));
        }
    }

    @Test
    void aRestartedRoverReportsAgain() {
        try (LabRobot robot = armed("rover+ready")) {
            robot.besideMavlink(vehicle -> vehicle.restart());
            pass(robot, 8);

            assertThat(robot.bot().isConnected()).isTrue();
            assertThat(robot.bot().get("armed")).isEqualTo(Value.yesNo(false));
            assertThat(robot.bot().get("age").number()).isLessThan(300);
        }
    }

    @Test
    void itsRangeFindersMeasureTheWall() {
        try (LabRobot robot = connected("rover+ready")) {
            pass(robot, 2);

            assertThat(robot.bot().get("distanceFront").number())
                    .isCloseTo(
                            4500
                                    - robot.truePose().xMm()
                                    - robot.bot().profile().bodyMm(),
                            within(400.0));
            assertThat(robot.bot().rangeSensors()).isNotEmpty();
        }
    }

    @Test
    void aCopterThatIsNotArmedIsShownAndStoppedAndNotMoved() {
        try (LabRobot robot = connected("copter+ready")) {
            MajicBot copter = robot.bot();
            pass(robot, 1);

            assertThat(copter.get("model").toString()).startsWith("copter");
            assertThatThrownBy(() -> copter.move(100)).hasMessageContaining("no fence is set");
            copter.stop();
            assertThat(mode(robot)).isEqualTo(BRAKE);
            robot.besideMavlink(vehicle -> {
                assertThat(vehicle.isArmed()).isFalse();
                assertThat(vehicle.heightM()).isZero();
            });
        }
    }
}
