package majic.ros;

import static majic.ros.RosLabSteps.WALL_X_MM;
import static majic.ros.RosLabSteps.aside;
import static majic.ros.RosLabSteps.connected;
import static majic.ros.RosLabSteps.frontMm;
import static majic.ros.RosLabSteps.pass;
import static majic.ros.RosLabSteps.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.inlab.LabRobot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Parameters, commands and goals of the simulated robot, compared with where it really is. */
class RosSensorsInLabTest {
    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+stamped", "2+namespace=tb3_0"})
    void allParametersHaveValuesSoonAfterTheRobotIsConnected(String model) {
        try (LabRobot robot = connected(model, 3500)) {
            pass(robot, 1.5);
            List<String> names = robot.bot().parameters().stream()
                    .filter(Parameter::readable)
                    .map(Parameter::name)
                    .toList();

            assertThat(names)
                    .contains("distanceFront", "scan", "bumped", "battery", "voltage", "gyro", "joints", "goalLeft");
            for (String name : names) {
                if (!List.of("goalLeft", "charging").contains(name) && !name.startsWith("distance")) {
                    assertThat(robot.bot().get(name).toString()).as(name).doesNotMatch("unknown \\(no reading.*");
                }
            }
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void theDistanceAheadIsThatFromTheHullToTheWall(String model) {
        try (LabRobot robot = connected(model, WALL_X_MM - 1000)) {
            double hullMm = robot.bot().profile().bodyMm();

            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(1000 - hullMm, within(20.0));
            assertThat(robot.bot().get("scanNearest").number()).isLessThanOrEqualTo(1001);
            assertThat(robot.bot().get("scanBeams")).isEqualTo(Value.of(360, Unit.NONE));
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2+stamped"})
    void aGuardOnTheDistanceEndsAMotionBeforeTheWall(String model) {
        try (LabRobot robot = connected(model, WALL_X_MM - 1000)) {
            MotionReport report = robot.bot()
                    .move(2000, () -> robot.bot().get("distanceFront").number() < 300);

            assertThat(frontMm(robot)).isBetween(200.0, 300.0);
            assertThat(report.amount()).isNotNull();
        }
    }

    @Test
    void aRobotWithItsBumperAtTheWallIsBumpedOnlyWhileItIs() {
        try (LabRobot robot = connected("1", 3500)) {
            assertThat(robot.bot().get("bumped")).isEqualTo(Value.yesNo(false));
            robot.block();

            assertThatThrownBy(() -> robot.bot().move(300)).isInstanceOf(MotionFailed.class);
            Value atTheWall = robot.bot().get("bumped");
            robot.bot().move(-100);
            pass(robot, 0.5);

            assertThat(atTheWall).isEqualTo(Value.yesNo(true));
            assertThat(robot.bot().get("hazards")).isEqualTo(Value.text("none"));
        }
    }

    @Test
    void aFieldOfATopicIsReadByItsName() {
        try (LabRobot robot = connected("2+namespace=tb3_0", 3500)) {
            assertThat(robot.bot().get("topic/imu/linear_acceleration/z").number())
                    .isCloseTo(9.8, within(0.1));
            assertThat(robot.bot().get("topic/tb3_0/odom/child_frame_id").toString())
                    .contains("base_footprint");
            assertThatThrownBy(() -> robot.bot().get("topic/imus"))
                    .hasMessage("imus: the robot has no such topic; near ones are tb3_0/imu");
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+unblocked"})
    void topicsAndServicesAreUsable(String model) {
        try (LabRobot robot = connected(model, 3500)) {
            assertThat(run(robot, "topics", "laser")).matches("/scan \\(sensor_msgs/(msg/)?LaserScan\\)");
            assertThat(run(robot, "topic", "battery_state")).contains("percentage: ");
            assertThat(run(robot, "call", "rosapi/topic_type", "topic=/scan")).contains("LaserScan");
            assertThatThrownBy(() -> run(robot, "call", "rosapi/topic_typ"))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("the robot has no such service; did you mean /rosapi/topic_type?");
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+stamped", "2+unblocked"})
    void theRobotDrivesToAPlaceByItsOwnNavigation(String model) {
        try (LabRobot robot = connected(model, 3000)) {
            String answer = run(robot, "goto", 500, 200, 90);

            assertThat(answer).startsWith("arrived at ");
            assertThat(robot.truePose().distanceMm(new Pose(3500, 200, 0))).isLessThan(150);
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+unblocked"})
    void aStopCancelsTheGoalAndTheRobotStaysWhereItIs(String model) {
        try (LabRobot robot = connected(model, 2000)) {
            Pose start = robot.truePose();
            CompletableFuture<String> drive = aside(robot, "goto", 2000, 0);
            while (robot.truePose().distanceMm(start) < 200) {
                pass(robot, 0.05);
            }

            robot.bot().stop();

            Pose stopped = robot.truePose();
            pass(robot, 3);
            assertThat(robot.truePose().distanceMm(stopped)).isLessThan(5);
            assertThatThrownBy(drive::join)
                    .isInstanceOf(CompletionException.class)
                    .cause()
                    .isInstanceOf(MotionStopped.class);
            assertThat(robot.bot().move(100).amount()).isNotNull();
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+unblocked"})
    void aStopCancelsTheGoalOfAnotherProgram(String model) {
        try (LabRobot robot = connected(model, 1000);
                MajicBot other = robot.another()) {
            other.connect();
            Pose start = robot.truePose();
            List<Value> place = List.of(Value.of(3000, Unit.NONE), Value.of(0, Unit.NONE));
            CompletableFuture<String> drive = new CompletableFuture<>();
            other.time()
                    .thread("other", () -> drive.completeAsync(() -> other.run("goto", place), Runnable::run))
                    .start();
            while (robot.truePose().distanceMm(start) < 200) {
                pass(robot, 0.05);
            }

            robot.bot().stop();

            Pose stopped = robot.truePose();
            pass(robot, 3);
            assertThat(robot.truePose().distanceMm(stopped)).isLessThan(5);
            assertThatThrownBy(drive::join).hasMessageContaining("the goal was cancelled on the robot");
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+unblocked"})
    void aGoalThatWasPursuedWhenTheConnectionWasLostIsCancelledByTheNextOne(String model) {
        try (LabRobot robot = connected(model, 1000)) {
            Pose start = robot.truePose();
            CompletableFuture<String> drive = aside(robot, "goto", 3000, 0);
            while (robot.truePose().distanceMm(start) < 200) {
                pass(robot, 0.05);
            }
            robot.cut();
            Pose lost = robot.truePose();
            pass(robot, 2);
            assertThat(drive).isCompletedExceptionally();
            assertThat(robot.truePose().distanceMm(lost))
                    .as("the robot goes on by itself")
                    .isGreaterThan(100);

            robot.bot().connect();
            pass(robot, 0.5);

            Pose stopped = robot.truePose();
            pass(robot, 3);
            assertThat(robot.truePose().distanceMm(stopped)).isLessThan(5);
        }
    }

    @Test
    void aRobotWithoutNavigationHasNoCommandForIt() {
        try (LabRobot robot = connected("2+nonavigation", 3500)) {
            assertThat(robot.bot().commands()).extracting(BotCommand::name).containsExactly("topics", "topic", "call");
        }
    }
}
