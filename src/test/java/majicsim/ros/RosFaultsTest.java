package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import majicsim.world.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The faults that can be ordered, and a bridge that demands authentication. */
class RosFaultsTest {
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
    void connectionsCanBeClosedWithACode() throws IOException {
        client.settle();
        stand.lab().besideRos(robot -> robot.closeConnections(1001, "restart"));
        RawWebSocket.Received close = client.socket().read();
        assertThat(close.opcode()).isEqualTo(RawWebSocket.CLOSE);
        assertThat(close.closeCode()).isEqualTo(1001);
        assertThat(client.socket().isEnded()).isTrue();
    }

    @Test
    void pingsCanStayUnanswered() throws IOException {
        stand.lab().besideRos(robot -> robot.suppressPongs(true));
        client.socket().sendBytes(RawWebSocket.frame(RawWebSocket.PING, true, new byte[1]));
        client.send("{'op':'call_service','id':'after','service':'/rosapi/get_time'}");
        assertThat(client.socket().read().text()).contains("after");
    }

    @Test
    void servicesCanStayUnanswered() throws IOException {
        stand.lab().besideRos(robot -> robot.suppressServices(true));
        client.send("{'op':'call_service','id':'lost','service':'/rosapi/get_time'}");
        client.socket().sendBytes(RawWebSocket.frame(RawWebSocket.PING, true, new byte[1]));
        assertThat(client.socket().read().opcode()).isEqualTo(RawWebSocket.PONG);
        stand.lab().besideRos(robot -> robot.suppressServices(false));
        assertThat(client.values("/rosapi/get_time").has("time")).isTrue();
    }

    @Test
    void answersCanBeMalformed() throws IOException {
        stand.lab().besideRos(robot -> robot.malform(1));
        client.send("{'op':'call_service','id':'cut','service':'/rosapi/nodes'}");
        assertThat(client.socket().read().text()).startsWith("{\"op\"").doesNotEndWith("}");
        assertThat(client.values("/rosapi/nodes").path("nodes")).isNotEmpty();
    }

    @Test
    void topicsCanBeMissing() throws IOException {
        stand.lab().besideRos(robot -> robot.hideTopics("/odom|/scan"));
        assertThat(client.values("/rosapi/topics").path("topics").toString())
                .doesNotContain("/odom", "/scan\"")
                .contains("/cmd_vel");
        stand.lab().besideRos(robot -> robot.hideTopics(""));
        assertThat(client.values("/rosapi/topics").path("topics").toString()).contains("/odom");
    }

    @Test
    void odometryCanStop() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        stand.lab().besideRos(robot -> robot.silence("/odom", true));
        client.taken();
        stand.pass(1);
        assertThat(client.taken()).isEmpty();
        stand.lab().besideRos(robot -> robot.silence("/odom", false));
        assertThat(client.message("/odom").has("pose")).isTrue();
    }

    @Test
    void scansCanBeSpoilt() throws IOException {
        stand.lab().besideRos(robot -> robot.spoilScans(true));
        client.sendAll("{'op':'subscribe','topic':'/scan'}");
        JsonNode ranges = client.message("/scan").path("ranges");
        long unusable = 0;
        for (JsonNode range : ranges) {
            unusable += range.isNull() || range.asDouble() == 0 ? 1 : 0;
        }
        assertThat(unusable).isGreaterThanOrEqualTo(240);
    }

    @Test
    void aTopicCanFloodAtAThousandHertz() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/imu'}");
        stand.lab().besideRos(robot -> robot.rate("/imu", 1000));
        client.taken();
        stand.pass(0.2);
        assertThat(client.taken()).hasSize(200);
    }

    @Test
    void theClockCanJumpBackWhileTopicsGoOn() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        long before = seconds(client.message("/odom"));
        stand.lab().besideRos(robot -> robot.jumpClock(-3600));
        client.taken();
        assertThat(seconds(client.message("/odom")) - before).isCloseTo(-3600L, within(1L));
    }

    private static long seconds(JsonNode message) {
        return message.path("header").path("stamp").path("secs").asLong();
    }

    @Test
    void aHugeMessageArrivesWhole() throws IOException, InterruptedException {
        client.settle();
        stand.lab().besideRos(robot -> robot.sendHuge(3_000_000));
        Thread steps = new Thread(() -> stand.pass(5));
        steps.start();
        String text = client.socket().read().text();
        steps.join();
        assertThat(text).hasSize(3_000_000);
        assertThat(RosStand.json(text).path("topic").asText()).isEqualTo("/odom");
    }

    @Test
    void aHugeMessageMustBeLongEnoughForItsFields() {
        assertThatThrownBy(() -> stand.lab().besideRos(robot -> robot.sendHuge(10)))
                .hasMessage("a huge message has 100 bytes or more, not 10");
    }

    @Test
    void onRos1ARejectedGoalIsReported() throws IOException {
        stand.lab().besideRos(robot -> robot.rejectGoals(true));
        client.sendAll(
                "{'op':'subscribe','topic':'/move_base/result'}",
                "{'op':'publish','topic':'/move_base/goal','msg':{'goal_id':{'id':'mine'}}}");
        assertThat(client.message("/move_base/result")
                        .path("status")
                        .path("status")
                        .asInt())
                .isEqualTo(5);
    }

    @Test
    void anUnknownTopicOfTheRobotIsRefusedByName() {
        assertThatThrownBy(() -> stand.lab().besideRos(robot -> robot.silence("/sonar", true)))
                .hasMessage("the robot does not publish /sonar");
    }

    @Test
    void aClientThatDoesNotAuthenticateIsClosed() throws IOException {
        try (RosStand guarded = new RosStand("1+auth=secret");
                RawWebSocket socket = RawWebSocket.open(guarded.address())) {
            socket.sendText("{\"op\":\"call_service\",\"service\":\"/rosapi/topics\"}");
            assertThat(socket.read().opcode()).isEqualTo(RawWebSocket.CLOSE);
            assertThat(socket.isEnded()).isTrue();
        }
    }

    @Test
    void aClientThatAuthenticatesIsServedWithoutAnAnswer() throws IOException, NoSuchAlgorithmException {
        String signed = "secret" + "me" + "robot" + "xyz" + "1" + "admin" + "2";
        String mac = HexFormat.of()
                .formatHex(MessageDigest.getInstance("SHA-512").digest(signed.getBytes(StandardCharsets.UTF_8)));
        try (RosStand guarded = new RosStand("1+auth=secret");
                RosStand.Client known = guarded.client()) {
            known.send("{'op':'auth','mac':'" + mac + "','client':'me','dest':'robot','rand':'xyz','t':1,"
                    + "'level':'admin','end':2}");
            assertThat(known.values("/rosapi/topics").path("topics")).isNotEmpty();
        }
    }

    @Test
    void aBridgeThatHungGoesOnWithWhatArrivedMeanwhile() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        client.taken();
        stand.lab().besideRos(robot -> robot.hang(true));
        stand.pass(1);
        client.send("{'op':'call_service','id':'held','service':'/rosapi/get_time'}");
        awaitReceived(client);
        stand.lab().besideRos(robot -> robot.hang(false));
        assertThat(client.socket().read().text()).contains("held");
    }

    @Test
    void theStopBehindAVelocityIsLostIfTheConnectionIsClosedWhileTheBridgeHangs() throws IOException {
        try (RosStand forEver = new RosStand("2");
                RosStand.Client watcher = forEver.client()) {
            watcher.settle();
            try (RosStand.Client lost = forEver.client()) {
                lost.settle();
                forEver.lab().besideRos(robot -> robot.hang(true));
                lost.send("{'op':'publish','topic':'/cmd_vel','msg':{'linear':{'x':0.1}}}");
                lost.send("{'op':'publish','topic':'/cmd_vel','msg':{}}");
            }
            while (connections(forEver) > 1) {
                Thread.onSpinWait();
            }
            forEver.lab().besideRos(robot -> robot.hang(false));
            Pose start = forEver.pose();
            forEver.pass(1);
            assertThat(forEver.pose().distanceTo(start)).isCloseTo(100, within(5.0));
        }
    }

    private static long connections(RosStand stand) {
        return stand.lab().lines().stream()
                .filter(line -> line.robot().equals(stand.address()))
                .count();
    }

    /** Waits until the robot's end has read what was sent, which it does not answer. */
    private void awaitReceived(RosStand.Client sender) {
        long sent = sender.sentBytes();
        while (stand.lab().lines().stream().noneMatch(line -> line.consumed() == sent)) {
            Thread.onSpinWait();
        }
    }
}
