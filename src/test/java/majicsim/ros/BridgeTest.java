package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import majicsim.world.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The rules of a rosbridge server that a client depends on, on ROS 1. */
class BridgeTest {
    @AutoClose
    private RosStand stand;

    @AutoClose
    private RosStand.Client client;

    @BeforeEach
    void open() throws IOException {
        stand = new RosStand("1");
        client = stand.client();
    }

    @Test
    void theTopicsIncludeTheCommandThatHasOnlyASubscriber() throws IOException {
        JsonNode values = client.values("/rosapi/topics");
        assertThat(values.path("topics").toString()).contains("/cmd_vel", "/odom", "/scan", "/battery_state");
        assertThat(values.path("types")).hasSameSizeAs(values.path("topics"));
        assertThat(client.call("/rosapi/publishers", "{'topic':'/cmd_vel'}").path("values"))
                .isEqualTo(RosStand.json("{\"publishers\":[]}"));
    }

    @Test
    void odometryComesAtItsRateOrAsThrottled() throws IOException {
        client.send("{'op':'subscribe','topic':'/odom','throttle_rate':100,'queue_length':1}");
        client.settle();
        stand.pass(2);
        assertThat(client.taken()).hasSizeBetween(19, 21);
    }

    @Test
    void theRobotDrivesAndStopsHalfASecondAfterTheLastCommand() throws IOException {
        Pose start = stand.pose();
        client.drive(0.2, 0);
        stand.pass(2);
        assertThat(stand.pose().distanceTo(start)).isCloseTo(100, within(10.0));
    }

    @Test
    void odometryAgreesWithTheTruePath() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        client.drive(0.1, 0);
        JsonNode odometry = client.message("/odom");
        Pose start = stand.pose();
        for (int i = 0; i < 50; i++) {
            odometry = client.message("/odom");
        }
        double moved =
                odometry.path("pose").path("pose").path("position").path("x").asDouble();
        assertThat(moved * 1000)
                .isCloseTo(stand.pose().distanceTo(start), within(5.0))
                .isGreaterThan(40);
    }

    @Test
    void aScanHas360BeamsAndNullWhereNothingIsInReach() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/scan'}");
        JsonNode scan = client.message("/scan");
        assertThat(scan.path("ranges")).hasSize(360);
        assertThat(scan.path("ranges")).anyMatch(JsonNode::isNull).anyMatch(JsonNode::isNumber);
    }
}
