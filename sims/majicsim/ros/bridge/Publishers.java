package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.Map;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.MessageType;
import org.jspecify.annotations.Nullable;

/**
 * The publishers of all clients. A topic's publisher remains for 10 s after the last client has disconnected (sheet 2).
 */
final class Publishers {
    private static final long KEPT_NANOS = 10_000_000_000L;

    private final RosNetwork network;
    private final Map<String, Shared> byTopic = new LinkedHashMap<>();

    Publishers(RosNetwork network) {
        this.network = network;
    }

    /** Registers one more user of a topic; a null type means that of the existing topic. */
    void register(String name, @Nullable String typeName) throws MessageMismatch {
        Topic existing = network.topics().find(name);
        if (typeName == null && existing == null) {
            throw new MessageMismatch("the topic " + name + " has no type");
        }
        MessageType type = typeName == null ? existing.type() : type(typeName);
        if (existing != null && existing.type() != type) {
            throw new MessageMismatch("the topic " + name + " has the type " + existing.type());
        }
        byTopic.computeIfAbsent(name, key -> new Shared(network.advertise(Peer.NODE, name, type.plainName()))).users++;
    }

    void unregister(String name) {
        Shared shared = byTopic.get(name);
        if (shared != null) {
            shared.users--;
            shared.leftNanos = network.clock().elapsedNanos();
        }
    }

    /** The type of a registered topic. */
    MessageType typeOf(String name) throws MessageMismatch {
        Shared shared = byTopic.get(name);
        if (shared == null) {
            throw new MessageMismatch("the topic " + name + " is not advertised");
        }
        return shared.topic.type();
    }

    void publish(String name, ObjectNode message, boolean latched) {
        Topic topic = byTopic.get(name).topic;
        if (latched) {
            topic.latch(message);
        } else {
            topic.publish(message);
        }
    }

    /** Ends publishers that have had no user for long enough. */
    void step() {
        long now = network.clock().elapsedNanos();
        byTopic.values().removeIf(shared -> {
            boolean ends = shared.users == 0 && now - shared.leftNanos >= KEPT_NANOS;
            if (ends) {
                shared.topic.removePublisher(Peer.NODE);
            }
            return ends;
        });
    }

    private MessageType type(String name) throws MessageMismatch {
        return network.types().find(name).orElseThrow(() -> new MessageMismatch(name + " is not a valid type string"));
    }

    private static final class Shared {
        private final Topic topic;
        private int users;
        private long leftNanos;

        Shared(Topic topic) {
            this.topic = topic;
        }
    }
}
