package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.Map;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.MessageType;
import org.jspecify.annotations.Nullable;

/** The subscriptions of all clients, and their operations subscribe and unsubscribe (sheet 3). */
final class Subscribers {
    private static final long NANOS_PER_MS = 1_000_000;

    private final RosNetwork network;
    private final JsonForm form;
    private final Map<String, TopicSubscription> subscriptions = new LinkedHashMap<>();

    Subscribers(RosNetwork network, JsonForm form) {
        this.network = network;
        this.form = form;
    }

    /**
     * The operation subscribe, by the name that the client uses for the topic; without a type, of an existing topic.
     */
    void subscribe(Peer peer, JsonNode message) throws MessageMismatch {
        String name = Fields.text(message, "topic");
        String typeName = message.has("type") ? Fields.text(message, "type") : null;
        Topic topic = topic(network.absolute(name), typeName);
        TopicSubscription subscription = subscriptions.get(name);
        if (subscription == null || subscription.topic() != topic) {
            subscription = new TopicSubscription(topic, name, network, form);
            subscriptions.put(name, subscription);
        }
        subscription.subscribe(peer, Fields.id(message), options(message));
    }

    private static SubscriptionOptions options(JsonNode message) throws MessageMismatch {
        return new SubscriptionOptions(
                Fields.number(message, "throttle_rate", 0) * NANOS_PER_MS,
                Fields.number(message, "queue_length", 0),
                message.path("compression").asText("none"));
    }

    private Topic topic(String name, @Nullable String typeName) throws MessageMismatch {
        Topic existing = network.topics().find(name);
        if (typeName == null) {
            if (existing == null) {
                throw new MessageMismatch("the topic " + name + " has no type");
            }
            return existing;
        }
        MessageType type = network.types()
                .find(typeName)
                .orElseThrow(() -> new MessageMismatch(typeName + " is not a valid type string"));
        if (existing != null && existing.type() != type) {
            throw new MessageMismatch("the topic " + name + " has the type " + existing.type());
        }
        return existing != null ? existing : network.topics().at(name, type);
    }

    /** The operation unsubscribe: ends one subscription of a client, or without an id all of its for a topic. */
    void unsubscribe(Peer peer, JsonNode message) throws MessageMismatch {
        String name = Fields.text(message, "topic");
        String id = message.has("id") ? Fields.id(message) : null;
        TopicSubscription subscription = subscriptions.get(name);
        TopicStream stream =
                subscription == null ? null : subscription.streams().get(peer);
        if (stream != null && (id == null || stream.end(id))) {
            subscription.streams().remove(peer);
            tidy(subscription);
        }
    }

    /** Ends all subscriptions of a client. */
    void end(Peer peer) {
        for (TopicSubscription subscription : subscriptions.values().toArray(TopicSubscription[]::new)) {
            if (subscription.streams().remove(peer) != null) {
                tidy(subscription);
            }
        }
    }

    private void tidy(TopicSubscription subscription) {
        if (subscription.streams().isEmpty()) {
            subscription.topic().unsubscribe(subscription);
            subscriptions.remove(subscription.name());
        }
    }

    void step() {
        subscriptions.values().forEach(TopicSubscription::step);
    }

    long dueNanos() {
        return subscriptions.values().stream()
                .mapToLong(TopicSubscription::dueNanos)
                .min()
                .orElse(Long.MAX_VALUE);
    }
}
