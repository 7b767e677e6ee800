package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/**
 * Replays a session with a real server: the same messages are sent, and the replies must have the same form. What
 * clients themselves published and what the server said about errors must be the same in content too.
 */
class RosCaptureTest {
    /** What the robot publishes by itself: only the form of a first message can be compared. */
    private static final Set<String> STREAMS = Set.of("/odom", "/scan", "/battery_state");

    @AutoClose
    private final RosStand stand = new RosStand("1+nonavigation");

    private final Map<String, RosStand.Client> clients = new LinkedHashMap<>();
    private int compared;

    RosCaptureTest() throws IOException {}

    @Test
    void theRepliesHaveTheFormOfTheCapturedOnes() throws IOException {
        try (RosStand.Client stub = stand.client()) {
            startTestTopics(stub);
            ArrayDeque<String> lines = lines();
            while (!lines.isEmpty()) {
                exchange(lines);
            }
        } finally {
            for (RosStand.Client client : clients.values()) {
                client.close();
            }
        }
        assertThat(compared).isGreaterThan(50);
    }

    private static void startTestTopics(RosStand.Client stub) throws IOException {
        stub.sendAll(
                "{'op':'advertise','topic':'/int64_test','type':'std_msgs/Int64','latch':true}",
                "{'op':'publish','topic':'/int64_test','msg':{'data':9007199254740993}}",
                "{'op':'advertise','topic':'/bytes_test','type':'std_msgs/ByteMultiArray','latch':true}",
                "{'op':'publish','topic':'/bytes_test','msg':{'data':[1,-2,3]}}");
    }

    private static ArrayDeque<String> lines() throws IOException {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                Objects.requireNonNull(RosCaptureTest.class.getResourceAsStream("rosbridge-ros1.txt")),
                StandardCharsets.UTF_8))) {
            return new ArrayDeque<>(
                    reader.lines().filter(line -> !line.startsWith("#")).toList());
        }
    }

    /** Sends everything up to the next reply, then compares all replies. */
    private void exchange(ArrayDeque<String> lines) throws IOException {
        String firstSent = String.valueOf(lines.peek());
        while (!lines.isEmpty() && lines.peek().contains(" -> ")) {
            String line = lines.remove();
            String text = line.substring(line.indexOf(" -> ") + 4);
            client(line).socket().sendText(text.replace("/turtlebot3_fake_node", "/turtlebot3_core"));
            client(line).settle();
        }
        Map<RosStand.Client, List<JsonNode>> expected = new LinkedHashMap<>();
        while (!lines.isEmpty() && lines.peek().contains(" <- ")) {
            String line = lines.remove();
            expected.computeIfAbsent(client(line), key -> new ArrayList<>())
                    .add(RosStand.json(line.substring(line.indexOf(" <- ") + 4)));
        }
        for (RosStand.Client client : clients.values()) {
            compare(firstSent, client, expected.getOrDefault(client, List.of()));
        }
    }

    private RosStand.Client client(String line) throws IOException {
        String name = line.substring(0, 1);
        if (!clients.containsKey(name)) {
            clients.put(name, stand.client());
        }
        return clients.get(name);
    }

    private void compare(String sent, RosStand.Client client, List<JsonNode> captured) throws IOException {
        List<JsonNode> replies = new ArrayList<>();
        for (JsonNode reply : client.taken()) {
            if (!STREAMS.contains(reply.path("topic").asText())) {
                replies.add(reply);
            }
        }
        for (JsonNode expected : captured) {
            JsonNode reply;
            if (STREAMS.contains(expected.path("topic").asText())) {
                reply = client.await(message -> message.path("topic").equals(expected.path("topic")));
            } else {
                assertThat(replies).as("replies to " + sent).isNotEmpty();
                reply = replies.remove(0);
            }
            assertThat(fits(expected, reply))
                    .as(reply + " has the form of " + expected)
                    .isTrue();
            if (isSameInContent(expected)) {
                assertThat(withoutTimes(reply)).isEqualTo(withoutTimes(expected));
            }
            compared++;
        }
        assertThat(replies).as("further replies to " + sent).isEmpty();
    }

    private static boolean isSameInContent(JsonNode captured) {
        boolean isStream = STREAMS.contains(captured.path("topic").asText());
        boolean isPublished = captured.path("op").asText().equals("publish") && !isStream;
        return isPublished
                || captured.path("result").isBoolean()
                        && !captured.path("result").booleanValue();
    }

    /**
     * Whether both have the same names in the same order with the same types; null fits any number, an empty list any
     * other.
     */
    private static boolean fits(JsonNode captured, JsonNode reply) {
        if (captured.isObject()) {
            return reply.isObject()
                    && namesOf(captured).equals(namesOf(reply))
                    && namesOf(captured).stream().allMatch(name -> fits(captured.get(name), reply.get(name)));
        }
        if (captured.isArray()) {
            return reply.isArray() && (captured.isEmpty() || reply.isEmpty() || fits(captured.get(0), reply.get(0)));
        }
        if (captured.isIntegralNumber()) {
            return reply.isIntegralNumber();
        }
        return isNumber(captured) ? isNumber(reply) : captured.getNodeType() == reply.getNodeType();
    }

    private static List<String> namesOf(JsonNode object) {
        List<String> names = new ArrayList<>();
        object.fieldNames().forEachRemaining(names::add);
        return names;
    }

    /** What a float can be. */
    private static boolean isNumber(JsonNode node) {
        return node.isNull() || node.isFloatingPointNumber();
    }

    /** Replaces the times that a clock gave, which are later than 2001. */
    private static JsonNode withoutTimes(JsonNode node) {
        node.findValues("stamp").forEach(stamp -> {
            if (stamp.path("secs").asLong() > 1_000_000_000) {
                ((ObjectNode) stamp).removeAll();
            }
        });
        return node;
    }
}
