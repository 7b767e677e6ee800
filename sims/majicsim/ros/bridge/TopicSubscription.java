package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.Map;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import majicsim.ros.graph.TopicListener;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageOutput;
import majicsim.ros.message.RosVersion;

/** The bridge's one subscription to a topic, for all clients that asked for the topic by the same name. */
final class TopicSubscription implements TopicListener {
    private final Topic topic;
    private final String name;
    private final RosNetwork network;
    private final MessageOutput output;
    private final JsonForm form;
    private final Map<Peer, TopicStream> streams = new LinkedHashMap<>();
    private long count;

    TopicSubscription(Topic topic, String name, RosNetwork network, JsonForm form) {
        this.topic = topic;
        this.name = name;
        this.network = network;
        this.output = new MessageOutput(network.types());
        this.form = form;
    }

    Topic topic() {
        return topic;
    }

    /** The name that its clients use, with or without a slash in front. */
    String name() {
        return name;
    }

    Map<Peer, TopicStream> streams() {
        return streams;
    }

    void subscribe(Peer peer, String id, SubscriptionOptions options) {
        TopicStream known = streams.get(peer);
        if (known != null) {
            known.options(id, options);
            return;
        }
        TopicStream stream = new TopicStream(peer);
        stream.options(id, options);
        streams.put(peer, stream);
        ObjectNode latched = topic.latched();
        if (streams.size() == 1) {
            topic.subscribe(Peer.NODE, this);
        } else if (latched != null) {
            stream.take(encoded(latched), network.clock().elapsedNanos());
        }
    }

    private Encoded encoded(ObjectNode message) {
        return new Encoded(topic, name, output.numbered(topic.type(), message, count), output, form);
    }

    /** On ROS 1 one client that does not read stalls the topic for all; ROS 2 keeps everything in memory for it. */
    @Override
    public void published(ObjectNode message) {
        boolean stalls = network.types().version() == RosVersion.ROS1
                && streams.values().stream().anyMatch(TopicStream::stalls);
        count++;
        if (!stalls) {
            Encoded encoded = encoded(message);
            long now = network.clock().elapsedNanos();
            streams.values().forEach(stream -> stream.take(encoded, now));
        }
    }

    void step() {
        long now = network.clock().elapsedNanos();
        streams.values().forEach(stream -> stream.step(now));
    }

    long dueNanos() {
        return streams.values().stream().mapToLong(TopicStream::dueNanos).min().orElse(Long.MAX_VALUE);
    }
}
