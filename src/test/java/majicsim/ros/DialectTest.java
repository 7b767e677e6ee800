package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import majicsim.ros.options.RosOptions;
import majicsim.world.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is different on ROS 2. */
class DialectTest {
    @AutoClose
    private RosStand stand;

    @AutoClose
    private RosStand.Client client;

    @BeforeEach
    void open() throws IOException {
        stand = new RosStand("2");
        client = stand.client();
    }

    @Test
    void theVersionIsAnswered() throws IOException {
        assertThat(client.values("/rosapi/get_ros_version"))
                .isEqualTo(RosStand.json("{\"version\":2,\"distro\":\"humble\"}"));
    }

    @Test
    void typesHaveThreePartsAndAreFoundByThemAlone() throws IOException {
        assertThat(type("/cmd_vel")).isEqualTo("geometry_msgs/msg/Twist");
        assertThat(client.call("/rosapi/topics_for_type", "{'type':'nav_msgs/msg/Odometry'}")
                        .path("values")
                        .path("topics"))
                .hasSize(1);
        assertThat(client.call("/rosapi/topics_for_type", "{'type':'nav_msgs/Odometry'}")
                        .path("values")
                        .path("topics"))
                .isEmpty();
    }

    private String type(String topic) throws IOException {
        return client.call("/rosapi/topic_type", "{'topic':'" + topic + "'}")
                .path("values")
                .path("type")
                .asText();
    }

    @Test
    void aSubscriptionTakesTypesOfTwoPartsToo() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom','type':'nav_msgs/Odometry'}");
        JsonNode header = client.message("/odom").path("header");
        assertThat(header.path("stamp").fieldNames()).toIterable().containsExactly("sec", "nanosec");
        assertThat(header.has("seq")).isFalse();
    }

    @Test
    void aMessageWithANumberOfItsHeaderIsDropped() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/p','type':'geometry_msgs/msg/PoseStamped'}",
                "{'op':'subscribe','topic':'/p'}",
                "{'op':'publish','topic':'/p','msg':{'header':{'seq':1}}}");
        assertThat(client.taken()).isEmpty();
    }

    @Test
    void bothNamesOfTimesAreTaken() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/p','type':'geometry_msgs/msg/PoseStamped'}",
                "{'op':'subscribe','topic':'/p'}",
                "{'op':'publish','topic':'/p','msg':{'header':{'stamp':{'secs':5,'nsecs':6}}}}",
                "{'op':'publish','topic':'/p','msg':{'header':{'stamp':{'sec':5,'nanosec':6}}}}");
        assertThat(client.taken())
                .hasSize(2)
                .allSatisfy(
                        message -> assertThat(message.path("msg").path("header").path("stamp"))
                                .isEqualTo(RosStand.json("{\"sec\":5,\"nanosec\":6}")));
    }

    @Test
    void fixedArraysHoldBareWordsThatAreNoJson() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/i','type':'sensor_msgs/msg/Imu'}",
                "{'op':'subscribe','topic':'/i'}",
                "{'op':'publish','topic':'/i','msg':{'orientation':{'x':NaN},"
                        + "'orientation_covariance':[NaN,Infinity,-Infinity,0,0,0,0,0,0]}}");
        assertThat(client.texts())
                .anySatisfy(text -> assertThat(text)
                        .contains("\"orientation\":{\"x\":null,")
                        .contains("\"orientation_covariance\":[NaN,Infinity,-Infinity,0.0,"));
    }

    @Test
    void aMissingRotationIsNone() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/p','type':'geometry_msgs/msg/PoseStamped'}",
                "{'op':'subscribe','topic':'/p'}",
                "{'op':'publish','topic':'/p','msg':{}}");
        assertThat(client.message("/p").path("pose").path("orientation"))
                .isEqualTo(RosStand.json("{\"x\":0.0,\"y\":0.0,\"z\":0.0,\"w\":1.0}"));
    }

    @Test
    void aWrongArgumentIsReportedWithTheNameOfTheRequest() throws IOException {
        assertThat(client.call("/rosapi/topic_type", "{'wrong':1}")
                        .path("values")
                        .asText())
                .isEqualTo("Message type rosapi_msgs/TopicType_Request does not have a field wrong");
    }

    @Test
    void aSlashIsNotEscaped() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        client.message("/odom");
        assertThat(client.texts()).anySatisfy(text -> assertThat(text).contains("\"topic\":\"/odom\""));
    }

    @Test
    void aPendingGoalHoldsUpTheConnectionAndAnotherConnectionCancelsIt() throws IOException {
        client.send("{'op':'send_action_goal','id':'g','action':'/navigate_to_pose',"
                + "'action_type':'nav2_msgs/action/NavigateToPose',"
                + "'args':{'pose':{'header':{'frame_id':'map'},'pose':{'position':{'x':1},'orientation':{'w':1}}}}}");
        client.send("{'op':'call_service','id':'late','service':'/rosapi/get_time'}");
        try (RosStand.Client other = stand.client()) {
            other.sendAll("{'op':'subscribe','topic':'/cmd_vel'}");
            other.message("/cmd_vel");
            other.sendAll("{'op':'cancel_action_goal','id':'g','action':'/navigate_to_pose'}");
        }
        assertThat(client.socket().read().text())
                .startsWith("{\"op\":\"action_result\",\"action\":\"/navigate_to_pose\",\"values\":{},\"status\":5,"
                        + "\"result\":true,\"id\":\"g\"}");
        assertThat(client.socket().read().text()).contains("\"id\":\"late\"");
    }

    @Test
    void aBridgeFromVersion22OnHoldsNothingUp() throws IOException {
        try (RosStand newer = new RosStand("2+unblocked");
                RosStand.Client one = newer.client()) {
            one.send("{'op':'send_action_goal','id':'g','action':'/missing','action_type':'x/action/X','args':{}}");
            assertThat(one.values("/rosapi/get_time").has("time")).isTrue();
        }
    }

    @Test
    void aRejectedGoalNeverAnswersAndItsConnectionIsLost() throws IOException {
        stand.lab().besideRos(robot -> robot.rejectGoals(true));
        client.send("{'op':'send_action_goal','id':'g','action':'/navigate_to_pose',"
                + "'action_type':'nav2_msgs/action/NavigateToPose','args':{}}");
        client.send("{'op':'call_service','id':'late','service':'/rosapi/get_time'}");
        client.socket().sendBytes(RawWebSocket.frame(RawWebSocket.PING, true, new byte[1]));
        stand.pass(10);
        assertThat(client.socket().read().opcode()).isEqualTo(RawWebSocket.PONG);
    }

    @Test
    void stampedCommandsHaveTheirTypeAndTheNewerDistribution() throws IOException {
        try (RosStand stamped = new RosStand("2+stamped");
                RosStand.Client one = stamped.client()) {
            assertThat(one.call("/rosapi/topic_type", "{'topic':'/cmd_vel'}")
                            .path("values")
                            .path("type")
                            .asText())
                    .isEqualTo("geometry_msgs/msg/TwistStamped");
            assertThat(one.values("/rosapi/get_ros_version").path("distro").asText())
                    .isEqualTo("jazzy");
        }
    }

    @Test
    void namesMayLieInANamespace() throws IOException {
        try (RosStand spaced = new RosStand("2+namespace=tb3_0");
                RosStand.Client one = spaced.client()) {
            assertThat(one.values("/rosapi/topics").path("topics").toString())
                    .contains("\"/tb3_0/cmd_vel\"", "\"/tb3_0/odom\"")
                    .doesNotContain("\"/odom\"");
        }
    }

    @Test
    void severalRobotsBehindOneBridgeDriveByThemselves() throws IOException {
        try (RosStand pair = new RosStand("2+robots=2");
                RosStand.Client one = pair.client()) {
            Pose first = pair.pose();
            Pose second = pair.lab().truePoses().get("ros2");
            one.sendAll("{'op':'publish','topic':'/tb3_1/cmd_vel','msg':{'linear':{'x':0.1}}}");
            pair.pass(1);
            assertThat(pair.pose()).isEqualTo(first);
            assertThat(pair.lab().truePoses().get("ros2").distanceTo(second)).isGreaterThan(90);
            assertThat(pair.lab().addresses().get("ros2")).isEqualTo(pair.address() + "/tb3_1");
        }
    }

    @Test
    void aModelThatDoesNotExistIsRefusedWithThoseThatDo() {
        assertThatThrownBy(() -> RosOptions.parse("2+fast"))
                .hasMessageStartingWith("there is no 'fast' for a ROS robot; known are 1 or 2, then +stamped ");
        assertThatThrownBy(() -> RosOptions.parse("1+timeout=soon"))
                .hasMessage("timeout must be seconds or none, not 'soon'");
        assertThatThrownBy(() -> RosOptions.parse("2+auth=x")).hasMessage("auth exists with ROS 1 only");
    }

    @Test
    void aServerInANamespaceHasItsServicesThere() throws IOException {
        try (RosStand inside = new RosStand("2+namespace=tb3+server=tb3");
                RawWebSocket socket = RawWebSocket.open(inside.address())) {
            socket.sendText("{\"op\":\"call_service\",\"service\":\"/tb3/rosapi/topics\"}");
            assertThat(RosStand.json(socket.read().text())
                            .path("values")
                            .path("topics")
                            .toString())
                    .contains("/tb3/odom");
            socket.sendText("{\"op\":\"call_service\",\"service\":\"rosapi/get_ros_version\"}");
            assertThat(RosStand.json(socket.read().text()).path("result").asBoolean())
                    .isTrue();
            socket.sendText("{\"op\":\"call_service\",\"service\":\"/rosapi/topics\"}");
            assertThat(RosStand.json(socket.read().text()).path("result").asBoolean())
                    .isFalse();
        }
    }

    @Test
    void aServerInANamespaceExistsWithRos2Only() {
        assertThatThrownBy(() -> RosOptions.parse("1+server=tb3")).hasMessage("server exists with ROS 2 only");
    }
}
