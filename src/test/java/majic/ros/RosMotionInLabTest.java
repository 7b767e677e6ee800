package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Motions of the simulated robot, compared with where it really is. */
class RosMotionInLabTest {
    private static final double WALL_X_MM = 4500;
    private static final List<String> MODELS = List.of("1", "2", "2+stamped");
    private static final List<Double> DISTANCES_MM = List.of(20.0, 100.0, 1000.0, -300.0);
    private static final List<Double> ANGLES_DEG = List.of(5.0, 90.0, -180.0, 400.0);

    static Stream<Arguments> moves() {
        return MODELS.stream().flatMap(model -> DISTANCES_MM.stream().map(mm -> Arguments.of(model, mm)));
    }

    static Stream<Arguments> turns() {
        return MODELS.stream().flatMap(model -> ANGLES_DEG.stream().map(deg -> Arguments.of(model, deg)));
    }

    private static LabRobot connected(String model) {
        LabRobot robot = new LabRobot("ros", LabRig.exactWithRos(model)).at(1000, 0, 0);
        robot.bot().connect();
        return robot;
    }

    @ParameterizedTest(name = "ROS {0}: {1} mm")
    @MethodSource("moves")
    void aMoveEndsWithinTenMillimetres(String model, double mm) {
        try (LabRobot robot = connected(model)) {
            MotionReport report = robot.bot().move(mm);

            assertThat(robot.truePose().xMm() - 1000).isCloseTo(mm, within(10.0));
            assertThat(robot.truePose().yMm()).isCloseTo(0, within(10.0));
            assertThat(number(report)).isCloseTo(mm, within(10.0));
        }
    }

    @ParameterizedTest(name = "ROS {0}: {1} degrees")
    @MethodSource("turns")
    void aTurnEndsWithinADegree(String model, double degrees) {
        try (LabRobot robot = connected(model)) {
            robot.bot().turn(degrees);

            assertThat(Pose.normalised(robot.truePose().headingDeg() - degrees)).isCloseTo(0, within(1.0));
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+stamped"})
    void aStopAtTheHighestSpeedIsConfirmedWithinHalfASecond(String model) {
        try (LabRobot robot = connected(model)) {
            robot.bot().set("cruise", 220);
            Thrown motion = moving(robot);
            Pose here = robot.truePose();
            double before = seconds(robot);

            robot.bot().stop();

            assertThat(seconds(robot) - before).isLessThan(0.5);
            assertThat(motion.end()).isInstanceOf(MotionStopped.class);
            Pose there = robot.truePose();
            assertThat(there.distanceMm(here)).isLessThan(40);
            pass(robot, 2);
            assertThat(robot.truePose()).isEqualTo(there);
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void theBumperEndsAMotionAtAWall(String model) {
        try (LabRobot robot = connected(model)) {
            robot.block();

            assertThatThrownBy(() -> robot.bot().move(500))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageMatching("front bumper pressed after [23]\\d(\\.\\d)? mm");
        }
    }

    @Test
    void aBridgeThatDiesWhileARobotWithoutTimeoutMovesIsAWarningAndTheNextConnectionStopsIt() {
        try (LabRobot robot = connected("2")) {
            Thrown motion = moving(robot);

            robot.cut();

            assertThat(motion.end())
                    .isInstanceOf(LinkLost.class)
                    .hasMessageContaining("the robot may still be moving, since it keeps its last velocity");
            Pose lost = robot.truePose();
            pass(robot, 1);
            assertThat(robot.truePose().distanceMm(lost))
                    .as("the simulated robot drives on")
                    .isGreaterThan(100);

            robot.bot().connect();
            pass(robot, 1);

            Pose stopped = robot.truePose();
            pass(robot, 2);
            assertThat(robot.truePose()).isEqualTo(stopped);
            assertThat(robot.bot().state().pose().xMm()).isCloseTo(stopped.xMm() - 1000, within(10.0));
        }
    }

    /** The delay of the line, of which a radio link may have that much. */
    @ParameterizedTest(name = "{0} s each way")
    @ValueSource(doubles = {0.25, 0.3})
    void motionsOverASlowLineEndAtTheirTargetsAndStopsAreConfirmedAtRest(double delayS) {
        try (LabRobot robot = connected("1")) {
            robot.delayLine(delayS * 1000);
            pass(robot, 1);

            assertThat(number(robot.bot().move(200))).isCloseTo(200, within(10.0));
            assertThat(robot.truePose().xMm()).isCloseTo(1200, within(10.0));
            assertThat(number(robot.bot().turn(90))).isCloseTo(90, within(1.0));
            assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(1.0));

            robot.bot().drive(100, 0);
            pass(robot, 0.2);
            robot.bot().stop();
            Pose stopped = robot.truePose();
            pass(robot, 2);
            assertThat(robot.truePose()).isEqualTo(stopped);
        }
    }

    @Test
    void aBridgeThatDiesWhileARobotWithTimeoutMovesTellsWhenItStops() {
        try (LabRobot robot = connected("1")) {
            Thrown motion = moving(robot);

            robot.cut();

            assertThat(motion.end()).hasMessageContaining("the robot stops by itself 0.5 s after the last command");
        }
    }

    @Test
    void aSilentConnectionIsNoticedWithinOneAndAHalfSeconds() {
        try (LabRobot robot = connected("2")) {
            Thrown motion = moving(robot);
            double before = seconds(robot);

            robot.fallSilent();

            assertThat(motion.end()).isInstanceOf(BotException.class);
            while (robot.bot().connection() != MajicBot.Connection.LOST && seconds(robot) - before < 5) {
                pass(robot, 0.05);
            }
            assertThat(seconds(robot) - before).isLessThan(1.5);
        }
    }

    @Test
    void aMotionUntilAConditionEndsThere() {
        try (LabRobot robot = connected("2+stamped")) {
            double start = robot.bot().state().pose().xMm();

            MotionReport report =
                    robot.bot().move(1000, () -> robot.bot().state().pose().xMm() > start + 300);

            assertThat(number(report)).isBetween(300.0, 350.0);
            assertThat(robot.truePose().xMm() - 1000).isCloseTo(number(report), within(5.0));
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void aMotionUntilTheScanShowsAWallEndsBeforeIt(String model) {
        try (LabRobot robot = connected(model)) {
            MajicBot bot = robot.bot();
            bot.set("cruise", 220);
            robot.at(2000, 0, 0);
            pass(robot, 0.5);

            MotionReport report = bot.move(2400, () -> bot.get("distanceFront").number() < 400);

            double gapMm = WALL_X_MM - robot.truePose().xMm() - bot.profile().bodyMm();
            assertThat(gapMm).isBetween(300.0, 410.0);
            assertThat(number(report)).isCloseTo(robot.truePose().xMm() - 2000, within(10.0));
        }
    }

    private static double number(MotionReport report) {
        return report.amount() == null ? Double.NaN : report.amount().number();
    }

    private static double seconds(LabRobot robot) {
        return robot.bot().time().nanos() / 1e9;
    }

    private static void pass(LabRobot robot, double seconds) {
        try {
            robot.bot().time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Begins a move on a thread of its own; returns when the robot is at its cruising speed. */
    private static Thrown moving(LabRobot robot) {
        Thrown motion = new Thrown(robot);
        robot.bot().time().thread("motion", motion).start();
        Pose start = robot.truePose();
        while (robot.truePose().distanceMm(start) < 300) {
            pass(robot, 0.02);
        }
        return motion;
    }

    /** A move, and what it threw. */
    private static final class Thrown implements Runnable {
        private final LabRobot robot;
        private volatile boolean over;
        private volatile @Nullable Throwable thrown;

        Thrown(LabRobot robot) {
            this.robot = robot;
        }

        @Override
        public void run() {
            try {
                robot.bot().move(3000);
            } catch (RuntimeException e) {
                thrown = e;
            } finally {
                over = true;
            }
        }

        /** Waits for the end; returns what was thrown, null if nothing was. */
        @Nullable
        Throwable end() {
            while (!over) {
                pass(robot, 0.02);
            }
            return thrown;
        }
    }
}
