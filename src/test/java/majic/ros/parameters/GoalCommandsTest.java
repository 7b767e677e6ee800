package majic.ros.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import majic.bot.BotCommand;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.ros.message.OdometryMessage;
import majic.ros.readings.FakeRosClient;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GoalCommandsTest {
    private static final Map<String, String> MOVE_BASE = Map.of(
            "/move_base/goal", "move_base_msgs/MoveBaseActionGoal",
            "/move_base/result", "move_base_msgs/MoveBaseActionResult",
            "/odom", "nav_msgs/Odometry");

    private static final Map<String, String> CREATE_3 = Map.of(
            "/hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector", "/odom", "nav_msgs/msg/Odometry");

    private static FakeRosRobot ros1() {
        FakeRosRobot robot = new FakeRosRobot(new FakeRosClient(false, MOVE_BASE));
        robot.odometry(new OdometryMessage(new Pose(5000, 0, 90), 0, 0, "odom", "base_link"));
        robot.at(new Pose(0, 0, 0));
        return robot;
    }

    private static FakeRosRobot ros2() {
        FakeRosRobot robot = new FakeRosRobot(new FakeRosClient(true, CREATE_3));
        robot.actions("/navigate_to_pose", "/dock", "/undock");
        robot.odometry(new OdometryMessage(new Pose(0, 0, 0), 0, 0, "odom", "base_link"));
        robot.at(new Pose(0, 0, 0));
        return robot;
    }

    private static String goal(FakeRosRobot robot) {
        robot.clock()
                .until(() -> robot.client().sent.stream()
                        .anyMatch(sent -> sent.contains("goal /") || sent.startsWith("publish /move_base/goal")));
        return robot.client().sent.stream()
                .filter(sent -> sent.contains("goal"))
                .reduce((first, second) -> second)
                .orElseThrow()
                .replaceFirst("^\\w+ \\S+ ", "");
    }

    private static void result(FakeRosRobot robot, String goal, int status, String text) {
        String id = FakeRosClient.json(goal).at("/goal_id/id").asText();
        robot.client()
                .robotPublishes(
                        "/move_base/result",
                        "{'status':{'goal_id':{'id':'other'},'status':4,'text':'not this one'},'result':{}}");
        robot.client()
                .robotPublishes(
                        "/move_base/result",
                        "{'status':{'goal_id':{'id':'%s'},'status':%s,'text':'%s'},'result':{}}"
                                .formatted(id, status, text));
    }

    @Test
    void onlyARobotWithNavigationHasTheCommand() {
        try (FakeRosRobot robot = ros2()) {
            assertThat(robot.bot().commands())
                    .extracting(BotCommand::usage)
                    .contains(
                            "goto X Y [HEADING]",
                            "gotoMap X Y [HEADING]",
                            "dock",
                            "undock",
                            "call SERVICE [ARGUMENTS]...");
            robot.actions();
            assertThat(robot.bot().commands()).extracting(BotCommand::name).containsExactly("topics", "topic", "call");
        }
    }

    @Test
    void aPlaceOfMajicIsSentInTheFrameOfTheOdometry() {
        try (FakeRosRobot robot = ros1()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "200", "45"));
            JsonNode goal = FakeRosClient.json(goal(robot));

            assertThat(goal.at("/goal/target_pose/header/frame_id").asText()).isEqualTo("odom");
            JsonNode pose = goal.at("/goal/target_pose/pose");
            assertThat(pose.at("/position/x").asDouble()).isCloseTo(4.8, within(1e-9));
            assertThat(pose.at("/position/y").asDouble()).isCloseTo(1.0, within(1e-9));
            assertThat(pose.at("/orientation/z").asDouble()).isCloseTo(Math.sin(Math.toRadians(135) / 2), within(1e-9));

            robot.at(new Pose(990, 195, 44));
            result(robot, goal.toString(), 3, "Goal reached.");
            robot.clock().until(drive::isDone);
            assertThat(drive.join()).isEqualTo("arrived at 990 mm, 195 mm, 44 deg");
            assertThat(robot.client().sent).noneMatch(sent -> sent.contains("cancel"));
            assertThat(robot.client().subscribed()).doesNotContain("/move_base/result", "/move_base/status");
        }
    }

    @Test
    void withoutAHeadingTheRobotKeepsThatOfTheWay() {
        try (FakeRosRobot robot = ros2()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "0", "1000"));
            JsonNode orientation = FakeRosClient.json(goal(robot)).at("/pose/pose/orientation");
            assertThat(orientation.path("z").asDouble()).isCloseTo(Math.sin(Math.PI / 4), within(1e-9));
            robot.client().goal.result(4, FakeRosClient.json("{}"));
            robot.clock().until(drive::isDone);
        }
    }

    @Test
    void aPlaceOfTheRobotsMapIsSentAsItIs() {
        try (FakeRosRobot robot = ros1()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("gotoMap", "-1500", "2000", "90"));
            JsonNode goal = FakeRosClient.json(goal(robot));

            assertThat(goal.at("/goal/target_pose/header/frame_id").asText()).isEqualTo("map");
            assertThat(goal.at("/goal/target_pose/pose/position/x").asDouble()).isEqualTo(-1.5);
            result(robot, goal.toString(), 3, "");
            robot.clock().until(drive::isDone);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "4, Failed to find a plan, the robot gave the goal up: Failed to find a plan",
        "5, '', the robot gave the goal up",
        "2, '', the goal was cancelled on the robot"
    })
    void aGoalThatEndsOtherwiseFailsWithTheReason(int status, String text, String message) {
        try (FakeRosRobot robot = ros1()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "0"));
            result(robot, goal(robot), status, text);
            robot.clock().until(drive::isDone);

            assertThatThrownBy(drive::join)
                    .cause()
                    .isInstanceOf(MotionFailed.class)
                    .hasMessage(message);
        }
    }

    @ParameterizedTest
    @CsvSource({"true, cancel", "false, 'publish /move_base/cancel {\"id\":\"\"}'"})
    void aStopCancelsTheGoalBehindTheZeroVelocity(boolean isRos2, String cancel) {
        try (FakeRosRobot robot = isRos2 ? ros2() : ros1()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "0"));
            goal(robot);

            robot.bot().stop();
            List<String> sentByTheStop = List.copyOf(robot.client().sent);
            robot.clock().until(drive::isDone);

            assertThat(sentByTheStop).endsWith("publish /cmd_vel {}", cancel);
            assertThatThrownBy(drive::join).cause().isInstanceOf(MotionStopped.class);
            assertThat(robot.client().sent).filteredOn(cancel::equals).hasSize(1);
        }
    }

    @Test
    void aGoalThatIsNeverAnsweredIsCancelledAfterFiveSeconds() {
        try (FakeRosRobot robot = ros2()) {
            long before = robot.clock().time().nanos();
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "0"));
            robot.clock().until(drive::isDone);

            assertThatThrownBy(drive::join)
                    .cause()
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageStartingWith("the navigation of the robot did not take the goal within 5 s");
            assertThat(robot.clock().time().secondsSince(before)).isBetween(5.0, 5.2);
            assertThat(robot.client().sent).contains("cancel", "close");
        }
    }

    @Test
    void theWayThatIsLeftIsReported() {
        try (FakeRosRobot robot = ros2()) {
            assertThat(robot.bot().get("goalLeft")).isEqualTo(Value.unknown("no goal"));
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "0"));
            goal(robot);

            robot.client().goal.feedback(FakeRosClient.json("{'distance_remaining':0.73}"));

            assertThat(robot.bot().get("goalLeft")).isEqualTo(Value.of(730, Unit.MM));
            robot.at(new Pose(990, 0, 0));
            robot.client().goal.result(4, FakeRosClient.json("{'error_code':0}"));
            robot.clock().until(drive::isDone);
            assertThat(drive.join()).startsWith("arrived");
            assertThat(robot.bot().get("goalLeft")).isEqualTo(Value.unknown("no goal"));
        }
    }

    @Test
    void theLossOfTheConnectionOfAGoalFailsIt() {
        try (FakeRosRobot robot = ros2()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "0"));
            goal(robot);
            robot.client().goal.failed(new LinkLost("the server closed it"));
            robot.clock().until(drive::isDone);

            assertThatThrownBy(drive::join)
                    .isInstanceOf(CompletionException.class)
                    .cause()
                    .hasMessage("the robot gave the goal up: the server closed it");
        }
    }

    @Test
    void aCreate3Docks() {
        try (FakeRosRobot robot = ros2()) {
            CompletableFuture<String> docking = robot.aside(() -> robot.run("dock"));
            assertThat(goal(robot)).isEqualTo("{}");
            robot.client().goal.result(4, FakeRosClient.json("{'is_docked':true}"));
            robot.clock().until(docking::isDone);

            assertThat(docking.join()).isEqualTo("docked");
            assertThat(robot.client().sent).contains("goal /dock {}");
        }
    }

    @Test
    void aGoalWhoseArrivalTheOdometryDoesNotShowHasFailed() {
        try (FakeRosRobot robot = ros1()) {
            CompletableFuture<String> drive = robot.aside(() -> robot.run("goto", "1000", "200", "45"));
            String goal = goal(robot);

            robot.at(new Pose(150, 0, 0));
            result(robot, goal, 3, "Goal reached.");

            assertThatThrownBy(() -> robot.clock().join(drive))
                    .hasMessageContaining("reports its arrival, but by its odometry the robot is 873 mm from there: "
                            + "arrived at 150 mm, 0 mm, 0 deg");
        }
    }
}
