package majicsim.ros.bridge;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;

/** The stream of one topic to one client: its subscriptions merged, throttled and queued. */
final class TopicStream {
    private final Peer peer;
    private final Map<String, SubscriptionOptions> optionsById = new LinkedHashMap<>();
    private final ArrayDeque<Encoded> queue = new ArrayDeque<>();
    private SubscriptionOptions merged = new SubscriptionOptions(0, 0, "none");
    private long earliestNanos = Long.MIN_VALUE;

    TopicStream(Peer peer) {
        this.peer = peer;
    }

    void options(String id, SubscriptionOptions options) {
        optionsById.put(id, options);
        merge();
    }

    /** Ends one subscription; returns whether none is left. */
    boolean end(String id) {
        optionsById.remove(id);
        merge();
        return optionsById.isEmpty();
    }

    private void merge() {
        optionsById.values().stream().reduce(SubscriptionOptions::merged).ifPresent(all -> merged = all);
    }

    /** Whether a client that does not read stalls the topic for every other one: without a queue (sheet 1, rule 6). */
    boolean stalls() {
        return merged.queueLength() == 0 && peer.isSlow();
    }

    void take(Encoded message, long nowNanos) {
        if (merged.queueLength() > 0) {
            queue.add(message);
            while (queue.size() > merged.queueLength()) {
                queue.remove();
            }
            step(nowNanos);
        } else if (nowNanos >= earliestNanos) {
            send(message, nowNanos);
        }
    }

    /** Sends what waited for its time. */
    void step(long nowNanos) {
        while (!queue.isEmpty() && nowNanos >= earliestNanos && !peer.isSlow()) {
            send(queue.remove(), nowNanos);
        }
    }

    /** The time of the next message in the queue; never if it is empty. */
    long dueNanos() {
        return queue.isEmpty() ? Long.MAX_VALUE : earliestNanos;
    }

    private void send(Encoded message, long nowNanos) {
        earliestNanos = nowNanos + merged.throttleNanos();
        message.sendTo(peer, merged.compression());
    }
}
