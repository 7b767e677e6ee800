package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import majic.bot.LinkLost;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The messages of one topic on one connection, for all its subscriptions: the server merges the subscriptions of a
 * client, so there is one at the server. Thread-safe.
 */
final class TopicStream {
    private static final Logger LOG = System.getLogger(TopicStream.class.getName());

    /** How long a topic may be silent at first before it is subscribed to again; doubled each time. */
    private static final double FIRST_RENEWAL_S = 3;

    private static final double LONGEST_RENEWAL_S = 60;

    private final TimeSource time;
    private final Consumer<ObjectNode> send;
    private final List<RosSubscription> subscriptions = new CopyOnWriteArrayList<>();
    private volatile @Nullable TopicSubscription requested;
    private double renewalS = FIRST_RENEWAL_S;
    private long requestedNanos;
    private volatile long count;
    private volatile long newestNanos;

    /**
     * The stream of a topic that is not subscribed to yet.
     *
     * @param send sends an operation
     */
    TopicStream(TimeSource time, Consumer<ObjectNode> send) {
        this.time = time;
        this.send = send;
    }

    synchronized RosSubscription add(TopicSubscription wanted, MessageReceiver onMessage) {
        RosSubscription added = new RosSubscription(this, wanted, onMessage);
        subscriptions.add(added);
        TopicSubscription merged = merged(wanted);
        if (!merged.equals(requested)) {
            request(merged);
        }
        return added;
    }

    private TopicSubscription merged(TopicSubscription last) {
        int throttleMs = last.throttleMs();
        boolean binary = last.binary();
        for (RosSubscription each : subscriptions) {
            throttleMs = Math.min(throttleMs, each.wanted().throttleMs());
            binary |= each.wanted().binary();
        }
        return new TopicSubscription(last.topic(), last.type(), throttleMs, last.queueLength(), binary);
    }

    private void request(TopicSubscription merged) {
        ObjectNode subscribe = operation("subscribe", merged.topic());
        if (!merged.type().isEmpty()) {
            subscribe.put("type", merged.type());
        }
        subscribe.put("throttle_rate", merged.throttleMs());
        subscribe.put("queue_length", merged.queueLength());
        if (merged.binary()) {
            subscribe.put("compression", "cbor");
        }
        requested = merged;
        requestedNanos = time.nanos();
        send.accept(subscribe);
    }

    private static ObjectNode operation(String name, String topic) {
        ObjectNode operation = JsonNodeFactory.instance.objectNode();
        operation.put("op", name);
        operation.put("id", "majic:" + topic);
        operation.put("topic", topic);
        return operation;
    }

    /**
     * Ends one subscription: requests what the others need, or unsubscribes after the last one, if the connection is
     * still there.
     */
    synchronized void remove(RosSubscription ended) {
        TopicSubscription last = requested;
        if (!subscriptions.remove(ended) || last == null) {
            return;
        }
        try {
            if (subscriptions.isEmpty()) {
                requested = null;
                renewalS = FIRST_RENEWAL_S;
                send.accept(operation("unsubscribe", last.topic()));
            } else {
                requestRest(last);
            }
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "nothing to unsubscribe from", e);
        }
    }

    private void requestRest(TopicSubscription last) {
        TopicSubscription rest =
                merged(subscriptions.get(subscriptions.size() - 1).wanted());
        if (!rest.equals(last)) {
            request(rest);
        }
    }

    /**
     * Subscribes again to a topic without messages: ROS 2 fits the quality of service at that moment to the publishers,
     * so a best-effort sensor that started later is not received (rosbridge sheet 5).
     */
    synchronized void renewIfSilent() {
        TopicSubscription current = requested;
        if (current != null && count == 0 && time.secondsSince(requestedNanos) > renewalS) {
            renewalS = Math.min(2 * renewalS, LONGEST_RENEWAL_S);
            send.accept(operation("unsubscribe", current.topic()));
            request(current);
        }
    }

    /** Passes a message on, on the reader thread. What one subscription throws does not concern the others. */
    void receive(JsonNode message, int bytes) {
        newestNanos = time.nanos();
        count++;
        for (RosSubscription each : subscriptions) {
            try {
                each.receive(message, bytes);
            } catch (RuntimeException | Error e) {
                LOG.log(Level.WARNING, "could not process a message of " + each.topic(), e);
            }
        }
    }

    /**
     * Returns what has arrived; empty if the topic is not subscribed to now. Takes no lock, which is held while
     * sending.
     */
    Optional<TopicActivity> activity() {
        return Optional.ofNullable(requested)
                .map(wanted -> new TopicActivity(wanted.topic(), wanted.type(), count, ageS()));
    }

    long count() {
        return count;
    }

    double ageS() {
        return count == 0 ? Double.POSITIVE_INFINITY : time.secondsSince(newestNanos);
    }
}
