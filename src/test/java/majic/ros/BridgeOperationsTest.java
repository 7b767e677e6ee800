package majic.ros;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.dataformat.cbor.databind.CBORMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.drivertest.ScriptedPeer;
import majic.ros.bridge.ActionGoal;
import majic.ros.bridge.BridgeAddress;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.RosSubscription;
import majic.ros.bridge.ServiceFailed;
import majic.ros.bridge.TopicSubscription;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The operations of one connection to a rosbridge server. */
class BridgeOperationsTest {
    private static final int BINARY = 2;
    private static final String SCAN = "sensor_msgs/LaserScan";

    @AutoClose
    private final ScriptedRos robot = new ScriptedRos();

    private final ScriptedPeer peer = robot.peer;
    private final List<String> notices = Collections.synchronizedList(new ArrayList<>());
    private final List<JsonNode> messages = Collections.synchronizedList(new ArrayList<>());
    private volatile LinkLost lost;

    @AutoClose
    private RosBridge bridge;

    @BeforeEach
    void open() {
        int port = Integer.parseInt(peer.address().replaceFirst(".*:", ""));
        bridge = RosBridge.open(
                new BridgeAddress("127.0.0.1", port, "/", false),
                3000,
                peer.clock().time(),
                new RosBridge.Listener() {
                    @Override
                    public void lost(RosBridge from, LinkLost cause) {
                        lost = cause;
                    }

                    @Override
                    public void notice(String message) {
                        notices.add(message);
                    }
                });
    }

    private static ObjectNode empty() {
        return ScriptedRos.JSON.createObjectNode();
    }

    private RosSubscription subscribe(String topic, int throttleMs) {
        return bridge.subscribe(new TopicSubscription(topic, SCAN, throttleMs), message -> messages.add(message));
    }

    private List<JsonNode> operations(String kind) {
        synchronized (peer) {
            return robot.received.stream()
                    .filter(operation -> operation.path("op").asText().equals(kind))
                    .toList();
        }
    }

    private void send(String text) {
        peer.send(ServerFrames.text(text));
    }

    private void publish(String content) {
        send("{\"op\":\"publish\",\"topic\":\"\\/scan\",\"msg\":" + content + "}");
    }

    private void awaitMessages(int count) {
        peer.clock().until(() -> messages.size() >= count);
    }

    @Test
    void aServiceAnswersWithItsValues() {
        JsonNode values = bridge.call("/rosapi/nodes", empty(), 5);

        assertThat(values.path("nodes").get(2).asText()).isEqualTo("/rosapi");
    }

    @Test
    void theTextOfAFailureIsPassedOn() {
        assertThatThrownBy(() -> bridge.call("/no_such_service", empty(), 5))
                .isInstanceOfSatisfying(
                        ServiceFailed.class,
                        failed -> assertThat(failed.isAnswered()).isTrue())
                .hasMessage("/no_such_service: Service /no_such_service does not exist");
    }

    @Test
    void aServiceThatDoesNotAnswerIsGivenUpAndItsLateAnswerIgnored() {
        robot.wholeAnswer = call -> "{\"op\":\"status\"}";
        assertThatThrownBy(() -> bridge.call("/forbidden", empty(), 5))
                .isInstanceOfSatisfying(
                        ServiceFailed.class,
                        failed -> assertThat(failed.isAnswered()).isFalse())
                .hasMessage("/forbidden did not answer within 5.0 s");

        robot.wholeAnswer = call -> "";
        send("{\"op\":\"service_response\",\"id\":\"majic:call:1\",\"values\":{\"late\":1},\"result\":true}");
        assertThat(bridge.call("/rosapi/nodes", empty(), 5).has("late")).isFalse();
    }

    @Test
    void aThreadThatMustNotWaitCallsNothing() {
        assertThatThrownBy(() -> WaitPolicy.without(() -> {
                    bridge.call("/rosapi/nodes", empty(), 5);
                }))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("/rosapi/nodes cannot be called here");
        assertThat(operations("call_service")).isEmpty();
    }

    @Test
    void theEndOfTheConnectionEndsACallAndAllLaterOnes() {
        robot.hangsUpAtFirstRequest = true;

        assertThatThrownBy(() -> bridge.call("/rosapi/nodes", empty(), 5)).isInstanceOf(LinkLost.class);
        assertThat(lost).hasMessage("the rosbridge server closed it");
        assertThat(bridge.isOpen()).isFalse();
        assertThatThrownBy(() -> bridge.call("/rosapi/nodes", empty(), 5)).isInstanceOf(LinkLost.class);
        assertThatThrownBy(() -> bridge.publish("/cmd_vel", empty())).isInstanceOf(LinkLost.class);
    }

    @Test
    void theReasonOfAnOrderlyCloseIsPassedOn() {
        byte[] content = "..message too big".getBytes(UTF_8);
        content[0] = 0x03;
        content[1] = (byte) 0xF1;
        peer.send(ServerFrames.frame(ServerFrames.CLOSE, content));
        peer.clock().until(() -> lost != null);

        assertThat(lost).hasMessage("the rosbridge server closed it (1009: message too big)");
    }

    @Test
    void onlyTheNewestMessagesOfATopicAreAskedFor() {
        subscribe("/scan", 100);
        peer.clock().until(() -> robot.isSubscribed("/scan"));

        assertThat(operations("subscribe").get(0).toString())
                .isEqualTo("{\"op\":\"subscribe\",\"id\":\"majic:/scan\",\"topic\":\"/scan\",\"type\":\"" + SCAN
                        + "\",\"throttle_rate\":100,\"queue_length\":1}");
    }

    @Test
    void subscriptionsOfOneTopicShareAStreamWithTheLeastThrottle() {
        RosSubscription slow = subscribe("/scan", 500);
        RosSubscription fast = subscribe("/scan", 100);
        RosSubscription slower = subscribe("/scan", 1000);
        publish("{\"n\":1}");
        awaitMessages(3);

        assertThat(operations("subscribe"))
                .extracting(operation -> operation.path("throttle_rate").asInt())
                .containsExactly(500, 100);
        assertThat(slow.count()).isEqualTo(1);
        assertThat(fast.ageS()).isLessThan(1);

        slow.close();
        fast.close();
        assertThat(operations("unsubscribe")).isEmpty();
        slower.close();
        peer.clock().until(() -> operations("unsubscribe").size() == 1);
    }

    @Test
    void aFailureOfOneReceiverDoesNotConcernTheOthers() {
        bridge.subscribe(new TopicSubscription("/scan", SCAN, 0), message -> {
            throw new IllegalStateException("for the test");
        });
        subscribe("/scan", 0);
        publish("{\"n\":1}");
        publish("{\"n\":2}");
        awaitMessages(2);

        assertThat(bridge.isOpen()).isTrue();
    }

    @Test
    void aSilentTopicIsSubscribedToAgainAndOneWithMessagesIsNot() {
        subscribe("/scan", 100);
        subscribe("/odom", 100);
        peer.clock().until(() -> robot.isSubscribed("/odom"));
        long start = peer.millis();
        peer.clock().until(() -> {
            bridge.renewSilentSubscriptions();
            return peer.millis() - start > 4000;
        });

        assertThat(operations("unsubscribe"))
                .extracting(operation -> operation.path("topic").asText())
                .containsExactly("/scan");
        assertThat(operations("subscribe")).hasSize(3);
    }

    @Test
    void rubbishIsIgnoredWithOneNoticeAndTheNextMessageArrives() {
        subscribe("/scan", 0);
        send("{\"op\":\"publish\",");
        send("[1,2]");
        send("null");
        send("");
        send("{}{}");
        send("[".repeat(5000));
        peer.send(ServerFrames.frame(BINARY, new byte[] {(byte) 0xFF, 0, 1}));
        peer.send(ServerFrames.frame(BINARY, new byte[0]));
        send("{\"op\":[1],\"topic\":{}}");
        send("{\"op\":\"publish\",\"topic\":7}");
        send("{\"op\":\"service_response\",\"id\":{}}");
        send("{\"op\":\"fragment\",\"id\":\"a\",\"data\":\"{\",\"num\":0,\"total\":1.5}");
        publish("{\"n\":1}");
        awaitMessages(1);

        assertThat(notices)
                .containsExactly("the rosbridge server sends messages that are not JSON objects; they are ignored");
    }

    @Test
    void bareWordsForNumbersThatAreNotFiniteAreAccepted() {
        subscribe("/scan", 0);
        publish("{\"covariance\":[NaN,Infinity,-Infinity,0.5],\"id\":9007199254740993}");
        awaitMessages(1);

        JsonNode message = messages.get(0);
        assertThat(message.path("covariance").get(0).doubleValue()).isNaN();
        assertThat(message.path("covariance").get(2).doubleValue()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(message.path("id").longValue()).isEqualTo(9007199254740993L);
    }

    @Test
    void aNumberThatIsNotFiniteIsNeverSent() {
        ObjectNode message = empty();
        message.putObject("linear").put("x", Double.NaN);

        assertThatThrownBy(() -> bridge.publish("/cmd_vel", message)).isInstanceOf(IllegalArgumentException.class);
        bridge.call("/rosapi/nodes", empty(), 5);
        assertThat(operations("publish")).isEmpty();
    }

    @Test
    void fragmentsAreJoined() {
        subscribe("/scan", 0);
        String whole = "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"n\":7}}";
        send(fragment(whole.substring(0, 20), 0));
        send(fragment(whole.substring(20), 1));
        awaitMessages(1);

        assertThat(messages.get(0).path("n").asInt()).isEqualTo(7);
    }

    private static String fragment(String data, int number) {
        return ScriptedRos.JSON
                .createObjectNode()
                .put("op", "fragment")
                .put("id", "x")
                .put("data", data)
                .put("num", number)
                .put("total", 2.07)
                .toString();
    }

    @Test
    void aPictureArrivesAsCbor() throws IOException {
        bridge.subscribe(new TopicSubscription("/scan", SCAN, 200, 1, true), message -> messages.add(message));
        ObjectNode operation = empty().put("op", "publish").put("topic", "/scan");
        operation.putObject("msg").put("format", "jpeg").put("data", new byte[] {1, 2, 3});
        peer.send(ServerFrames.frame(BINARY, new CBORMapper().writeValueAsBytes(operation)));
        awaitMessages(1);

        assertThat(operations("subscribe").get(0).path("compression").asText()).isEqualTo("cbor");
        assertThat(messages.get(0).path("data").binaryValue()).containsExactly(1, 2, 3);
    }

    @Test
    void aHugeMessageIsLeftOutWithANoticeAndTheNextOneArrives() {
        subscribe("/scan", 0);
        byte[] huge = new byte[RosBridge.LONGEST_MESSAGE + 1];
        peer.send(ServerFrames.frame(ServerFrames.TEXT, huge));
        peer.send(ServerFrames.frame(ServerFrames.TEXT, huge));
        publish("{\"n\":1}");
        awaitMessages(1);

        assertThat(notices).hasSize(1).allMatch(notice -> notice.contains("more than 16 MB, which was left out"));
        assertThat(bridge.isOpen()).isTrue();
    }

    @Test
    void aFloodIsReadToItsEndAndOnlyCounted() {
        RosSubscription flood = bridge.subscribe(new TopicSubscription("/scan", SCAN, 0), message -> {});
        byte[] message = ServerFrames.text(
                "{\"op\":\"publish\",\"topic\":\"/scan\",\"msg\":{\"ranges\":[" + "1.25,".repeat(360) + "0]}}");
        for (int i = 0; i < 5000; i++) {
            peer.send(message);
        }
        peer.clock().until(() -> flood.count() == 5000);

        assertThat(bridge.call("/rosapi/nodes", empty(), 5).has("nodes")).isTrue();
    }

    @Test
    void aGoalReportsItsFeedbackAndItsResult() {
        List<String> events = Collections.synchronizedList(new ArrayList<>());
        String id = bridge.sendGoal(
                new ActionGoal("/dock", "irobot_create_msgs/action/Dock", empty()), new ActionGoal.Events() {
                    @Override
                    public void feedback(JsonNode values) {
                        events.add("feedback " + values);
                    }

                    @Override
                    public void result(int status, JsonNode values) {
                        events.add("result " + status + " " + values);
                    }

                    @Override
                    public void failed(BotException cause) {
                        events.add("failed " + cause.getMessage());
                    }
                });
        send("{\"op\":\"action_feedback\",\"id\":\"" + id + "\",\"values\":{\"near\":true}}");
        send("{\"op\":\"action_result\",\"id\":\"other\",\"status\":4,\"values\":{}}");
        send("{\"op\":\"action_result\",\"id\":\"" + id
                + "\",\"status\":4,\"result\":true,\"values\":{\"docked\":true}}");
        peer.clock().until(() -> events.size() == 2);
        bridge.cancelGoal("/dock", id);
        peer.clock().until(() -> !operations("cancel_action_goal").isEmpty());
        robot.cut();
        peer.clock().until(() -> lost != null);

        assertThat(events).containsExactly("feedback {\"near\":true}", "result 4 {\"docked\":true}");
        assertThat(operations("send_action_goal").get(0).path("action_type").asText())
                .isEqualTo("irobot_create_msgs/action/Dock");
    }

    @Test
    void theServersPingIsAnswered() {
        peer.send(ServerFrames.frame(ServerFrames.PING, "alive".getBytes(UTF_8)));
        peer.clock().until(() -> robot.pongs == 1);
    }

    @Test
    void silenceIsMeasuredFromTheLastByteAndAnAnswerToAPingEndsIt() {
        long start = peer.millis();
        peer.clock().until(() -> peer.millis() - start > 800);
        assertThat(bridge.silenceS()).isGreaterThan(0.7);

        bridge.ping();
        peer.clock().until(() -> bridge.silenceS() < 0.1);
    }
}
