package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.message.MessageInput;
import majicsim.ros.message.MessageMismatch;
import org.jspecify.annotations.Nullable;

/** advertise, unadvertise and publish of one client (sheet 3). */
final class PublishOperations {
    private static final String TOPIC = "topic";

    private final RosNetwork network;
    private final Publishers publishers;
    private final MessageInput input;

    /** The ids with which this client advertised, by topic. */
    private final Map<String, Set<String>> advertised = new HashMap<>();

    private final Set<String> latched = new HashSet<>();

    PublishOperations(RosNetwork network, Publishers publishers, MessageInput input) {
        this.network = network;
        this.publishers = publishers;
        this.input = input;
    }

    void advertise(JsonNode message) throws MessageMismatch {
        String topic = network.absolute(Fields.text(message, TOPIC));
        register(topic, Fields.text(message, "type"), Fields.id(message));
        if (message.path("latch").asBoolean()) {
            latched.add(topic);
        }
    }

    void unadvertise(JsonNode message) throws MessageMismatch {
        String topic = network.absolute(Fields.text(message, TOPIC));
        Set<String> ids = advertised.getOrDefault(topic, Set.of());
        if (message.has("id")) {
            ids.remove(Fields.id(message));
        }
        if (!message.has("id") || ids.isEmpty()) {
            release(topic);
        }
    }

    void publish(JsonNode message) throws MessageMismatch {
        String topic = network.absolute(Fields.text(message, TOPIC));
        if (!advertised.containsKey(topic)) {
            register(topic, null, Fields.id(message));
        }
        JsonNode received = message.path("msg");
        JsonNode content = received instanceof MissingNode ? JsonObjects.empty() : received;
        ObjectNode checked = input.checked(publishers.typeOf(topic), content);
        publishers.publish(
                topic, checked, latched.contains(topic) || message.path("latch").asBoolean());
    }

    void end() {
        Set.copyOf(advertised.keySet()).forEach(this::release);
    }

    private void register(String topic, @Nullable String type, String id) throws MessageMismatch {
        Set<String> ids = advertised.get(topic);
        if (ids == null) {
            publishers.register(topic, type);
            ids = new HashSet<>();
            advertised.put(topic, ids);
        }
        ids.add(id);
    }

    private void release(String topic) {
        if (advertised.remove(topic) != null) {
            publishers.unregister(topic);
        }
    }
}
