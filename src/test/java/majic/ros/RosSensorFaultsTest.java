package majic.ros;

import static majic.ros.RosLabSteps.aside;
import static majic.ros.RosLabSteps.connected;
import static majic.ros.RosLabSteps.frontMm;
import static majic.ros.RosLabSteps.pass;
import static majic.ros.RosLabSteps.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.CompletableFuture;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Sensors, services and goals of a simulated robot that does not do what it should. */
class RosSensorFaultsTest {
    private static final double X_MM = 3500;

    @ParameterizedTest(name = "ROS {0}")
    @CsvSource({
        "2, the navigation of the robot did not take the goal within 5 s",
        "2+unblocked, the navigation of the robot did not take the goal within 5 s",
        "1, the robot gave the goal up"
    })
    void aRejectedGoalFailsAndTheRobotIsUsableAfterwards(String model, String message) {
        try (LabRobot robot = connected(model, X_MM)) {
            robot.besideRos(ros -> ros.rejectGoals(true));

            assertThatThrownBy(() -> run(robot, "goto", 500, 0))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageStartingWith(message);

            robot.besideRos(ros -> ros.rejectGoals(false));
            assertThat(run(robot, "call", "rosapi/topic_type", "topic=/scan")).contains("LaserScan");
            assertThat(run(robot, "goto", 500, 0)).startsWith("arrived");
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+unblocked"})
    void aStopCancelsAGoalEvenIfServicesDoNotAnswer(String model) {
        try (LabRobot robot = connected(model, X_MM)) {
            robot.at(1000, 0, 0);
            Pose start = robot.truePose();
            CompletableFuture<String> drive = aside(robot, "goto", 3000, 0);
            while (robot.truePose().distanceMm(start) < 200) {
                pass(robot, 0.05);
            }
            robot.besideRos(ros -> ros.suppressServices(true));

            robot.bot().stop();

            Pose stopped = robot.truePose();
            pass(robot, 3);
            assertThat(robot.truePose().distanceMm(stopped)).isLessThan(5);
            assertThatThrownBy(drive::join).cause().isInstanceOf(MotionStopped.class);
        }
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2"})
    void aServiceThatDoesNotAnswerHoldsUpNothingElse(String model) {
        try (LabRobot robot = connected(model, X_MM)) {
            robot.besideRos(ros -> ros.suppressServices(true));

            assertThatThrownBy(() -> run(robot, "call", "rosapi/topic_type", "topic=/scan"))
                    .hasMessageContaining("did not answer within");

            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(frontMm(robot), within(20.0));
            assertThat(robot.bot().move(100).amount()).isNotNull();
        }
    }

    @Test
    void aScanInWhichTwoOfThreeReadingsAreUnusableStillGivesTheDistance() {
        try (LabRobot robot = connected("1", X_MM)) {
            robot.besideRos(ros -> ros.spoilScans(true));
            pass(robot, 1);

            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(frontMm(robot), within(20.0));
            assertThat(robot.bot().get("scanEchoes").number()).isBetween(50.0, 130.0);
        }
    }

    @Test
    void anOdometryThatFallsSilentMakesThePoseUnknownWhileOtherTopicsAreRead() {
        try (LabRobot robot = connected("1", X_MM)) {
            robot.besideRos(ros -> ros.silence("/odom", true));
            pass(robot, 2);

            assertThat(robot.bot().get("x")).isEqualTo(Value.unknown("no recent report"));
            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(frontMm(robot), within(20.0));

            robot.besideRos(ros -> ros.silence("/odom", false));
            pass(robot, 1);
            assertThat(robot.bot().get("x")).isNotInstanceOf(Value.Unknown.class);
        }
    }

    @Test
    void aScannerThatFallsSilentMakesDistancesUnknownAndEndsAGuardedMotion() {
        try (LabRobot robot = connected("1", X_MM)) {
            robot.at(1000, 0, 0);
            pass(robot, 1);
            robot.besideRos(ros -> ros.silence("/scan", true));

            assertThatThrownBy(() -> robot.bot()
                            .move(3000, () -> robot.bot().get("distanceFront").number() < 300))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageContaining("unknown (no reading of late)");

            assertThat(robot.truePose().xMm()).isLessThan(1400);
            assertThat(robot.bot().get("distanceFront")).isEqualTo(Value.unknown("no reading of late"));
            robot.besideRos(ros -> ros.silence("/scan", false));
            pass(robot, 1);
            assertThat(robot.bot().get("distanceFront")).isNotInstanceOf(Value.Unknown.class);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-3600, 3600, 1e8})
    void aJumpOfTheRobotsClockChangesNothing(double seconds) {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.besideRos(ros -> ros.jumpClock(seconds));
            pass(robot, 0.5);

            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(frontMm(robot), within(20.0));
            assertThat(run(robot, "goto", 300, 0)).startsWith("arrived");
        }
    }

    @Test
    void messagesThatAreCutOffAreLeftOut() {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.besideRos(ros -> ros.malform(30));
            pass(robot, 1);

            assertThat(robot.bot().get("distanceFront").number()).isCloseTo(frontMm(robot), within(20.0));
        }
    }

    @Test
    void aTopicThatFloodsIsReadLikeAnyOther() {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.besideRos(ros -> ros.rate("/imu", 1000));

            assertThat(robot.bot().get("gyro").number()).isCloseTo(0, within(1.0));
            assertThat(robot.bot().move(200).amount()).isNotNull();
        }
    }

    @Test
    void aRobotWithoutAScannerHasNoDistances() {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("1"))) {
            robot.besideRos(ros -> ros.hideTopics("/scan|/battery_state"));
            robot.bot().connect();

            assertThat(robot.bot().parameters())
                    .extracting(Parameter::name)
                    .contains("bumped", "gyro")
                    .doesNotContain("distanceFront", "scan", "battery");
        }
    }
}
