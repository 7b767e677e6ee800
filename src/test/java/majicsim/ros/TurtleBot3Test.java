package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Base64;
import javax.imageio.ImageIO;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The base, its sensors and its navigation. */
class TurtleBot3Test {
    @Test
    void onRos1ItStopsHalfASecondAfterTheLastCommand() throws IOException {
        assertThat(millimetresAfterOneCommand("1", 0.2, 4)).isCloseTo(100, within(12.0));
    }

    @Test
    void theTimeOutCanBeChosen() throws IOException {
        assertThat(millimetresAfterOneCommand("1+timeout=1.0", 0.1, 4)).isCloseTo(100, within(8.0));
    }

    @Test
    void onRos2ItDrivesOnForEver() throws IOException {
        assertThat(millimetresAfterOneCommand("2", 0.05, 10)).isCloseTo(500, within(5.0));
    }

    @Test
    void itIsNotFasterThanItsMotors() throws IOException {
        assertThat(millimetresAfterOneCommand("2", 5, 2)).isCloseTo(440, within(15.0));
    }

    @ParameterizedTest
    @CsvSource({
        "1, /robot_description",
        "2, /robot_state_publisher:robot_description",
        "2+namespace=tb3, /tb3/robot_state_publisher:robot_description"
    })
    void itsDescriptionIsAParameterWithTheJointsThatItReports(String model, String parameter) throws IOException {
        try (RosStand stand = new RosStand(model);
                RosStand.Client client = stand.client()) {
            JsonNode answer = client.call("/rosapi/get_param", "{'name':'" + parameter + "'}");
            String description =
                    RosStand.json(answer.path("values").path("value").asText()).asText();
            String topic = parameter.startsWith("/tb3") ? "/tb3/joint_states" : "/joint_states";
            client.sendAll("{'op':'subscribe','topic':'" + topic + "'}");

            assertThat(client.message(topic).path("name"))
                    .hasSize(2)
                    .allSatisfy(name -> assertThat(description)
                            .contains("joint name=\"" + name.asText() + "\" type=\"continuous\""));
            assertThat(client.values("/rosapi/nodes").toString()).contains("robot_state_publisher");
        }
    }

    @Test
    void onRos2SpeedsAreCutToHundredths() throws IOException {
        assertThat(millimetresAfterOneCommand("2", 0.009, 2)).isZero();
        assertThat(millimetresAfterOneCommand("2", 0.29 / 2, 2)).isCloseTo(280, within(5.0));
    }

    private static double millimetresAfterOneCommand(String model, double metresPerSec, double seconds)
            throws IOException {
        try (RosStand stand = new RosStand(model);
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            client.drive(metresPerSec, 0);
            stand.pass(seconds);
            return stand.pose().distanceTo(start);
        }
    }

    @Test
    void noStopIsPublishedForAClientThatGoesWhileItDrives() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client watcher = stand.client()) {
            Pose start = stand.pose();
            try (RosStand.Client client = stand.client()) {
                client.drive(0.1, 0);
            }
            watcher.sendAll("{'op':'subscribe','topic':'/cmd_vel'}");
            stand.pass(3);
            assertThat(stand.pose().distanceTo(start)).isCloseTo(300, within(5.0));
            assertThat(watcher.taken()).isEmpty();
        }
    }

    @Test
    void missingFieldsAreZeroAndAMessageWithoutContentStops() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client client = stand.client()) {
            client.drive(0.1, 1);
            client.sendAll("{'op':'publish','topic':'/cmd_vel'}");
            stand.pass(1);
            Pose stopped = stand.pose();
            stand.pass(1);
            assertThat(stand.pose()).isEqualTo(stopped);
        }
    }

    @Test
    void aStampedCommandThatIsTooOldIsRefused() throws IOException {
        try (RosStand stand = new RosStand("2+stamped+timeout=0.5");
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            String command = "{'op':'publish','topic':'/cmd_vel','msg':{'header':%s,'twist':{'linear':{'x':0.1}}}}";
            client.sendAll(command.formatted("{'stamp':{'sec':1,'nanosec':0}}"));
            stand.pass(1);
            assertThat(stand.pose()).isEqualTo(start);
            client.sendAll(command.formatted("{}"));
            stand.pass(1);
            assertThat(stand.pose().distanceTo(start)).isGreaterThan(40);
        }
    }

    @Test
    void odometryAgreesWithTheTruePath() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            client.drive(0.1, 0.5);
            client.sendAll("{'op':'subscribe','topic':'/odom'}");
            stand.pass(1.5);
            client.taken();
            JsonNode pose = client.message("/odom").path("pose").path("pose");
            double x = pose.path("position").path("x").asDouble();
            double y = pose.path("position").path("y").asDouble();
            double yaw = 2
                    * Math.atan2(
                            pose.path("orientation").path("z").asDouble(),
                            pose.path("orientation").path("w").asDouble());
            assertThat(Math.hypot(x, y) * 1000).isCloseTo(stand.pose().distanceTo(start), within(1.0));
            assertThat(Math.toDegrees(yaw))
                    .isCloseTo(Pose.normalised(stand.pose().headingDeg() - start.headingDeg()), within(0.5));
        }
    }

    @Test
    void odometryStandsStillWhileTheRobotPushesAWall() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client client = stand.client()) {
            client.drive(0.2, 0);
            client.sendAll("{'op':'subscribe','topic':'/sensor_state'}", "{'op':'subscribe','topic':'/odom'}");
            stand.pass(60);
            client.taken();
            assertThat(stand.lab().bumps()).containsEntry("ros", 1);
            assertThat(client.message("/odom")
                            .path("twist")
                            .path("twist")
                            .path("linear")
                            .path("x")
                            .asDouble())
                    .isZero();
            assertThat(client.message("/sensor_state").path("bumper").asInt()).isEqualTo(1);
        }
    }

    @Test
    void aScanHas360BeamsAndNullWhereNothingIsInReach() throws IOException {
        try (RosStand stand = new RosStand("1");
                RosStand.Client client = stand.client()) {
            client.sendAll("{'op':'subscribe','topic':'/scan'}");
            JsonNode scan = client.message("/scan");
            assertThat(scan.path("ranges")).hasSize(360);
            assertThat(scan.path("ranges")).anyMatch(JsonNode::isNull).anyMatch(JsonNode::isNumber);
            assertThat(scan.path("range_min").asDouble()).isEqualTo((double) 0.12f);
        }
    }

    @Test
    void aBeamMeasuresTheDistanceToTheWall() throws IOException {
        try (RosStand stand = new RosStand("1");
                RosStand.Client client = stand.client()) {
            stand.lab().place("ros", new Pose(3500, 0, 0));
            client.sendAll("{'op':'subscribe','topic':'/scan'}");
            double ahead = client.message("/scan").path("ranges").path(0).asDouble();
            assertThat(ahead).isCloseTo(1.032, within(0.02));
        }
    }

    @Test
    void theFixedFramesAreKeptForLaterSubscribers() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client client = stand.client()) {
            client.sendAll("{'op':'subscribe','topic':'/tf_static'}");
            assertThat(client.message("/tf_static").path("transforms").findValuesAsText("child_frame_id"))
                    .contains("base_link", "base_scan", "imu_link");
        }
    }

    @Test
    void theScaleOfThePercentageIsTheMakersOwn() throws IOException {
        assertThat(percentage("1")).isBetween(1.0, 1.2);
        assertThat(percentage("2")).isBetween(90.0, 100.0);
    }

    private static double percentage(String model) throws IOException {
        try (RosStand stand = new RosStand(model);
                RosStand.Client client = stand.client()) {
            client.sendAll("{'op':'subscribe','topic':'/battery_state'}");
            return client.message("/battery_state").path("percentage").asDouble();
        }
    }

    @Test
    void navigateToPoseDrivesToTheGoal() throws IOException {
        try (RosStand stand = new RosStand("2+unblocked");
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            client.sendAll("{'op':'send_action_goal','id':'g','action':'/navigate_to_pose',"
                    + "'action_type':'nav2_msgs/action/NavigateToPose','feedback':true,"
                    + "'args':{'pose':{'pose':{'position':{'x':0.5,'y':0.3},'orientation':{'z':1,'w':0}}}}}");
            assertThat(client.await(message -> message.path("op").asText().equals("action_feedback"))
                            .path("values")
                            .path("distance_remaining")
                            .asDouble())
                    .isPositive();
            assertThat(client.await(message -> message.path("op").asText().equals("action_result"))
                            .path("status")
                            .asInt())
                    .isEqualTo(4);
            assertThat(stand.pose().distanceTo(start)).isCloseTo(583, within(30.0));
            assertThat(Pose.normalised(stand.pose().headingDeg() - start.headingDeg() - 180))
                    .isCloseTo(0, within(3.0));
        }
    }

    @Test
    void moveBaseReportsItsGoalAndItsEnd() throws IOException {
        try (RosStand stand = new RosStand("1");
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            client.sendAll(
                    "{'op':'subscribe','topic':'/move_base/status'}",
                    "{'op':'subscribe','topic':'/move_base/result'}",
                    "{'op':'publish','topic':'/move_base/goal','msg':{'goal_id':{'id':'mine'},'goal':{'target_pose':"
                            + "{'header':{'frame_id':'map'},'pose':{'position':{'x':0.3},'orientation':{'w':1}}}}}}");
            assertThat(client.message("/move_base/status").findValuesAsText("id"))
                    .containsExactly("mine");
            JsonNode status = client.message("/move_base/result").path("status");
            assertThat(status.path("status").asInt()).isEqualTo(3);
            assertThat(status.path("goal_id").path("id").asText()).isEqualTo("mine");
            assertThat(stand.pose().distanceTo(start)).isCloseTo(300, within(25.0));
        }
    }

    @Test
    void anEmptyCancelEndsTheGoalOfMoveBase() throws IOException {
        try (RosStand stand = new RosStand("1");
                RosStand.Client client = stand.client()) {
            client.sendAll(
                    "{'op':'subscribe','topic':'/move_base/result'}",
                    "{'op':'publish','topic':'/move_base_simple/goal','msg':{'pose':{'position':{'x':1},"
                            + "'orientation':{'w':1}}}}");
            stand.pass(1);
            client.sendAll("{'op':'publish','topic':'/move_base/cancel','msg':{}}");
            assertThat(client.message("/move_base/result")
                            .path("status")
                            .path("status")
                            .asInt())
                    .isEqualTo(2);
            stand.pass(1);
            Pose stopped = stand.pose();
            stand.pass(1);
            assertThat(stand.pose()).isEqualTo(stopped);
        }
    }

    @Test
    void theServiceThatCancelsAllGoalsStopsTheNavigation() throws IOException {
        try (RosStand stand = new RosStand("2+unblocked");
                RosStand.Client client = stand.client()) {
            client.sendAll("{'op':'send_action_goal','id':'g','action':'/navigate_to_pose',"
                    + "'action_type':'nav2_msgs/action/NavigateToPose',"
                    + "'args':{'pose':{'pose':{'position':{'x':2},'orientation':{'w':1}}}}}");
            stand.pass(1);
            client.call("/navigate_to_pose/_action/cancel_goal", "{}");
            assertThat(client.await(message -> message.path("op").asText().equals("action_result"))
                            .path("status")
                            .asInt())
                    .isEqualTo(5);
        }
    }

    @Test
    void withoutMotorPowerCommandsHaveNoEffect() throws IOException {
        try (RosStand stand = new RosStand("2");
                RosStand.Client client = stand.client()) {
            Pose start = stand.pose();
            assertThat(client.call("/motor_power", "{'data':false}")
                            .path("values")
                            .path("success")
                            .asBoolean())
                    .isTrue();
            client.drive(0.1, 0);
            stand.pass(1);
            assertThat(stand.pose()).isEqualTo(start);
            client.call("/motor_power", "{'data':true}");
            client.drive(0.1, 0);
            stand.pass(1);
            assertThat(stand.pose().distanceTo(start)).isCloseTo(100, within(5.0));
        }
    }

    @Test
    void theCameraShowsANearWallLargerThanAFarOne() throws IOException {
        try (RosStand stand = new RosStand("2+camera");
                RosStand.Client client = stand.client()) {
            client.sendAll("{'op':'subscribe','topic':'/camera/image/compressed'}");
            stand.lab().place("ros", new Pose(4000, 0, 0));
            client.taken();
            int near = wallRows(client.message("/camera/image/compressed"));
            stand.lab().place("ros", new Pose(3000, 0, 0));
            client.taken();
            int far = wallRows(client.message("/camera/image/compressed"));
            assertThat(near).isGreaterThan(far + 10);
            assertThat(far).isPositive();
        }
    }

    /** How many pixels of the middle column differ from both ceiling and floor in colour: a wall is grey. */
    private static int wallRows(JsonNode message) throws IOException {
        assertThat(message.path("format").asText()).isEqualTo("jpeg");
        byte[] jpeg = Base64.getDecoder().decode(message.path("data").asText());
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(jpeg));
        int rows = 0;
        for (int row = 0; row < image.getHeight(); row++) {
            int rgb = image.getRGB(image.getWidth() / 2, row);
            int redLessBlue = (rgb >> 16 & 0xFF) - (rgb & 0xFF);
            rows += Math.abs(redLessBlue) < 8 ? 1 : 0;
        }
        return rows;
    }
}
