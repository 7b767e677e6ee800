package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.cbor.databind.CBORMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
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
        stand = new RosStand("1+nonavigation");
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
    void odometryComesAsOftenAsItIsThrottled() throws IOException {
        client.send("{'op':'subscribe','topic':'/odom','throttle_rate':100,'queue_length':1}");
        client.settle();
        stand.pass(2);
        assertThat(client.taken()).hasSizeBetween(19, 21);
    }

    @Test
    void withoutQueueTheLastMessageBeforeAPauseIsLostAndWithOneItComes() throws IOException {
        client.sendAll("{'op':'advertise','topic':'/n','type':'std_msgs/Int32'}");
        try (RosStand.Client queued = stand.client()) {
            queued.sendAll("{'op':'subscribe','topic':'/n','throttle_rate':1000,'queue_length':1}");
            client.sendAll("{'op':'subscribe','topic':'/n','throttle_rate':1000}");
            for (int i = 1; i <= 3; i++) {
                client.sendAll("{'op':'publish','topic':'/n','msg':{'data':" + i + "}}");
            }
            stand.pass(2);
            assertThat(numbers(client.taken())).containsExactly(1);
            assertThat(numbers(queued.taken())).containsExactly(1, 3);
        }
    }

    private static List<Integer> numbers(List<JsonNode> messages) {
        return messages.stream()
                .map(message -> message.path("msg").path("data").asInt())
                .toList();
    }

    @Test
    void aSlashIsEscapedAndAPublishedMessageHasNoId() throws IOException {
        client.sendAll("{'op':'subscribe','id':'mine','topic':'/odom'}");
        client.message("/odom");
        assertThat(client.texts())
                .anySatisfy(text -> assertThat(text)
                        .startsWith("{\"op\":\"publish\",\"topic\":\"\\/odom\",\"msg\":{\"header\":{\"seq\":")
                        .doesNotContain("mine"));
    }

    @Test
    void aBareNumberEndsTheInputForEverWhileSubscriptionsGoOn() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/odom'}");
        client.send("5");
        client.send("{'op':'publish','topic':'/cmd_vel','msg':{'linear':{'x':0.2}}}");
        client.socket().sendBytes(RawWebSocket.frame(RawWebSocket.PING, true, new byte[1]));
        assertThat(client.socket().read().opcode()).isEqualTo(RawWebSocket.PONG);
        Pose before = stand.pose();
        stand.pass(1);
        assertThat(client.socket().read().text()).contains("\\/odom");
        assertThat(stand.pose()).isEqualTo(before);
    }

    @Test
    void badJsonIsDroppedAndTheNextMessageWorks() throws IOException {
        client.send("{'op':'call_service','id':'broken'");
        client.send("not json at all");
        assertThat(client.call("/rosapi/get_time", "{}").path("result").asBoolean())
                .isTrue();
    }

    @Test
    void twoObjectsInOneFrameBothWork() throws IOException {
        client.send("{'op':'call_service','id':'a','service':'/rosapi/get_time'}"
                + "{'op':'call_service','id':'b','service':'/rosapi/get_time'}");
        assertThat(RosStand.json(client.socket().read().text()).path("id").asText())
                .isEqualTo("a");
        assertThat(RosStand.json(client.socket().read().text()).path("id").asText())
                .isEqualTo("b");
    }

    @Test
    void thePublisherRemainsTenSecondsAfterAClose() throws IOException {
        try (RosStand.Client other = stand.client()) {
            other.sendAll("{'op':'advertise','topic':'/cmd_vel','type':'geometry_msgs/Twist'}");
        }
        awaitClients(1);
        stand.pass(6);
        assertThat(publishersOfCommands()).contains("rosbridge_websocket");
        stand.pass(4.1);
        assertThat(publishersOfCommands()).doesNotContain("rosbridge_websocket");
    }

    private String publishersOfCommands() throws IOException {
        return client.call("/rosapi/publishers", "{'topic':'/cmd_vel'}")
                .path("values")
                .toString();
    }

    private void awaitClients(int count) throws IOException {
        try (RosStand.Client watcher = stand.client()) {
            watcher.sendAll("{'op':'subscribe','topic':'/client_count'}");
            watcher.await(message -> message.path("msg").path("data").asInt() == count + 1);
        }
    }

    @Test
    void aMessageInFragmentsIsPutTogether() throws IOException {
        client.send(
                "{'op':'fragment','id':'f','num':0,'total':2,'data':'{\\'op\\':\\'call_service\\',\\'id\\':\\'whole\\','}"
                        .replace("\\'", "\\\""));
        client.send("{'op':'fragment','id':'f','num':1,'total':2,'data':'\\'service\\':\\'/rosapi/get_time\\'}'}"
                .replace("\\'", "\\\""));
        assertThat(RosStand.json(client.socket().read().text()).path("id").asText())
                .isEqualTo("whole");
    }

    @Test
    void fragmentsAskedForHaveATotalThatIsNotWhole() throws IOException {
        client.send("{'op':'call_service','id':'f1','service':'/rosapi/topics','fragment_size':300}");
        StringBuilder whole = new StringBuilder();
        JsonNode part = RosStand.json(client.socket().read().text());
        double total = part.path("total").asDouble();
        for (int number = 0; number < Math.floor(total); number++) {
            part = number == 0 ? part : RosStand.json(client.socket().read().text());
            assertThat(part.path("op").asText()).isEqualTo("fragment");
            assertThat(part.path("id").asText()).isEqualTo("f1");
            assertThat(part.path("num").asInt()).isEqualTo(number);
            whole.append(part.path("data").asText());
        }
        assertThat(RosStand.json(whole.toString()).path("id").asText()).isEqualTo("f1");
        assertThat(total).isCloseTo(whole.length() / 300.0 + 1, within(1e-9));
    }

    @Test
    void aMessageAsPngHoldsItsTextInThePixels() throws IOException {
        client.sendAll("{'op':'subscribe','topic':'/battery_state','compression':'png'}");
        JsonNode png = client.await(message -> message.path("op").asText().equals("png"));
        byte[] file = Base64.getDecoder().decode(png.path("data").asText());
        byte[] pixels = (byte[]) ImageIO.read(new ByteArrayInputStream(file))
                .getData()
                .getDataElements(0, 0, widthOf(file), heightOf(file), null);
        assertThat(RosStand.json(new String(pixels, StandardCharsets.UTF_8).trim())
                        .path("topic")
                        .asText())
                .isEqualTo("/battery_state");
    }

    private static int widthOf(byte[] png) {
        return (png[18] & 0xFF) << 8 | png[19] & 0xFF;
    }

    private static int heightOf(byte[] png) {
        return (png[22] & 0xFF) << 8 | png[23] & 0xFF;
    }

    @Test
    void aMessageAsCborKeepsNotANumber() throws IOException {
        client.send("{'op':'subscribe','topic':'/battery_state','compression':'cbor'}");
        client.settle();
        stand.pass(0.3);
        RawWebSocket.Received frame = client.socket().read();
        assertThat(frame.opcode()).isEqualTo(RawWebSocket.BINARY);
        JsonNode message = new CBORMapper().readTree(frame.payload());
        assertThat(message.path("msg").path("current").asDouble()).isNaN();
        assertThat(message.path("topic").asText()).isEqualTo("/battery_state");
    }

    @Test
    void nothingIsSentAsCborOfATypeWithAnArrayOfFixedLengthOrWithTexts() throws IOException {
        client.sendAll(
                "{'op':'subscribe','topic':'/odom','compression':'cbor'}",
                "{'op':'subscribe','topic':'/imu','compression':'cbor'}",
                "{'op':'subscribe','topic':'/joint_states','compression':'cbor'}",
                "{'op':'subscribe','topic':'/cmd_vel'}");
        stand.pass(1);
        assertThat(client.taken()).isEmpty();

        client.sendAll("{'op':'subscribe','topic':'/scan','compression':'cbor'}");
        stand.pass(0.3);
        assertThat(client.socket().read().opcode()).isEqualTo(RawWebSocket.BINARY);
    }

    @Test
    void namesWithoutASlashInFrontAreThoseOfTheOutermostNamespace() throws IOException {
        assertThat(client.call("rosapi/topics", "{}")
                        .path("values")
                        .path("topics")
                        .toString())
                .contains("/odom");
        assertThat(client.call("rosapi/topics", "{}").path("service").asText()).isEqualTo("rosapi/topics");

        client.sendAll(
                "{'op':'subscribe','topic':'odom'}",
                "{'op':'subscribe','topic':'scan','type':'sensor_msgs/LaserScan'}");
        assertThat(client.message("odom").path("child_frame_id").asText()).isEqualTo("base_footprint");
        assertThat(client.message("scan").path("ranges")).isNotEmpty();

        Pose before = stand.pose();
        client.sendAll(
                "{'op':'advertise','topic':'cmd_vel','type':'geometry_msgs/Twist'}",
                "{'op':'publish','topic':'cmd_vel','msg':{'linear':{'x':0.2}}}");
        stand.pass(0.4);
        assertThat(stand.pose().xMm() - before.xMm()).isGreaterThan(20);
    }

    @Test
    void parametersAreListedSetFoundAndRemoved() throws IOException {
        assertThat(client.values("/rosapi/get_param_names").path("names").toString())
                .contains("\"/rosdistro\"", "\"/robot_description\"");
        client.call("/rosapi/set_param", "{'name':'/speed','value':'0.5'}");
        assertThat(value("/rosapi/get_param", "{'name':'/speed'}", "value")).isEqualTo("0.5");
        assertThat(value("/rosapi/has_param", "{'name':'/speed'}", "exists")).isEqualTo("true");
        assertThat(value("/rosapi/search_param", "{'name':'speed'}", "global_name"))
                .isEqualTo("/speed");
        client.call("/rosapi/delete_param", "{'name':'/speed'}");
        assertThat(value("/rosapi/has_param", "{'name':'/speed'}", "exists")).isEqualTo("false");
        assertThat(value("/rosapi/search_param", "{'name':'speed'}", "global_name"))
                .isEmpty();
    }

    @Test
    void servicesAreDescribed() throws IOException {
        assertThat(value("/rosapi/service_node", "{'service':'/rosapi/topics'}", "node"))
                .isEqualTo("/rosapi");
        assertThat(value("/rosapi/service_node", "{'service':'/nothing'}", "node"))
                .isEmpty();
        assertThat(value("/rosapi/service_host", "{'service':'/rosapi/topics'}", "host"))
                .isNotEmpty();
        assertThat(client.call("/rosapi/service_providers", "{'service':'rosapi/Topics'}")
                        .path("values"))
                .isEqualTo(RosStand.json("{\"providers\":[\"/rosapi\"]}"));
        assertThat(typedef("service_request_details", "rosapi/GetParam").path("fieldnames"))
                .isEqualTo(RosStand.json("[\"name\",\"default\"]"));
        assertThat(typedef("service_response_details", "rosapi/GetParam").path("fieldtypes"))
                .isEqualTo(RosStand.json("[\"string\"]"));
    }

    private JsonNode typedef(String question, String type) throws IOException {
        return client.call("/rosapi/" + question, "{'type':'" + type + "'}")
                .path("values")
                .path("typedefs")
                .path(0);
    }

    private String value(String service, String arguments, String field) throws IOException {
        return client.call(service, arguments).path("values").path(field).asText();
    }

    @Test
    void theTypesOfTopicsAreGivenAsText() throws IOException {
        JsonNode values = client.values("/rosapi/topics_and_raw_types");
        assertThat(values.path("typedefs_full_text")).hasSameSizeAs(values.path("topics"));
        assertThat(values.path("typedefs_full_text").toString())
                .contains("geometry_msgs/Vector3 linear", "MSG: geometry_msgs/Vector3", "float64[36] covariance");
    }

    @Test
    void aClientThatStopsReadingStallsTheTopicForTheOthersUnlessItHasAQueue() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/big','type':'std_msgs/String'}", "{'op':'subscribe','topic':'/big'}");
        try (RosStand.Client queued = stand.client();
                RosStand.Client slow = stand.client()) {
            queued.sendAll("{'op':'subscribe','topic':'/big','queue_length':1}");
            assertThat(publishBig(60)).isEqualTo(60);
            slow.sendAll("{'op':'subscribe','topic':'/big'}");
            assertThat(publishBig(60)).isLessThan(60);
            assertThat(publishBig(20)).isZero();
        }
    }

    /** Publishes 200 kB so many times, and returns how often this client received it. */
    private int publishBig(int times) throws IOException {
        String text = "x".repeat(200_000);
        for (int i = 0; i < times; i++) {
            client.sendAll("{'op':'publish','topic':'/big','msg':{'data':'" + text + "'}}");
            stand.pass(0.1);
        }
        return client.taken().size();
    }

    @Test
    void aServiceThatAClientOffersIsCalledThroughTheBridge() throws IOException {
        client.sendAll("{'op':'advertise_service','service':'/own','type':'std_srvs/Trigger'}");
        try (RosStand.Client caller = stand.client()) {
            caller.send("{'op':'call_service','id':'q1','service':'/own'}");
            assertThat(client.socket().read().text())
                    .isEqualTo("{\"op\":\"call_service\",\"id\":\"service_request:\\/own:1\",\"service\":\"\\/own\","
                            + "\"args\":{}}");
            client.send("{'op':'service_response','id':'service_request:/own:1','service':'/own',"
                    + "'values':{'success':true,'message':'hello'},'result':true}");
            assertThat(caller.socket().read().text())
                    .isEqualTo("{\"op\":\"service_response\",\"service\":\"\\/own\","
                            + "\"values\":{\"success\":true,\"message\":\"hello\"},\"result\":true,\"id\":\"q1\"}");
        }
    }

    @Test
    void aLatchedMessageReachesALaterSubscriberAlone() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/kept','type':'std_msgs/String','latch':true}",
                "{'op':'publish','topic':'/kept','msg':{'data':'kept'}}",
                "{'op':'subscribe','topic':'/kept'}");
        assertThat(client.taken()).hasSize(1);
        try (RosStand.Client later = stand.client()) {
            later.sendAll("{'op':'subscribe','topic':'/kept'}");
            assertThat(later.taken()).hasSize(1);
        }
        assertThat(client.taken()).isEmpty();
    }

    @Test
    void argumentsThatAreNeitherAnObjectNorAListCountAsNone() throws IOException {
        assertThat(client.call("/rosapi/topic_type", "5").path("values")).isEqualTo(RosStand.json("{\"type\":\"\"}"));
    }

    @Test
    void bytesAreReadAsPythonReadsBase64() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/img','type':'sensor_msgs/CompressedImage'}",
                "{'op':'subscribe','topic':'/img'}",
                "{'op':'publish','topic':'/img','msg':{'data':'!!!AQ!ID'}}",
                "{'op':'publish','topic':'/img','msg':{'data':'A'}}");
        assertThat(client.taken())
                .singleElement()
                .satisfies(message ->
                        assertThat(message.path("msg").path("data").asText()).isEqualTo("AQID"));
    }

    @Test
    void charactersBeyondAsciiAreEscaped() throws IOException {
        client.sendAll(
                "{'op':'advertise','topic':'/s','type':'std_msgs/String'}",
                "{'op':'subscribe','topic':'/s'}",
                "{'op':'publish','topic':'/s','msg':{'data':'\u00e4'}}");
        assertThat(client.texts()).anySatisfy(text -> assertThat(text).containsIgnoringCase("\\u00e4"));
    }
}
