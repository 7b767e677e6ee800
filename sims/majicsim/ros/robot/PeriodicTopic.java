package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.function.Supplier;
import majicsim.ros.graph.Topic;

/** A topic that is published at fixed times. A message is made only if something receives it. */
final class PeriodicTopic {
    private final Topic topic;
    private final Supplier<ObjectNode> maker;
    private long periodNanos;
    private long dueNanos;
    private boolean isSilent;

    /** Publishes for the first time one period from now. */
    PeriodicTopic(Topic topic, long periodNanos, Supplier<ObjectNode> maker) {
        this.topic = topic;
        this.maker = maker;
        this.periodNanos = periodNanos;
        this.dueNanos = periodNanos;
    }

    String name() {
        return topic.name();
    }

    /** Publishes from now on at another rate. */
    void period(long nanos, long nowNanos) {
        periodNanos = nanos;
        dueNanos = nowNanos + nanos;
    }

    /** Stops publishing, as a node that hangs, or goes on. */
    void silence(boolean silent) {
        isSilent = silent;
    }

    /** Publishes as often as was due up to now. */
    void step(long nowNanos) {
        if (isSilent || !topic.hasSubscribers()) {
            skipTo(nowNanos);
            return;
        }
        while (dueNanos <= nowNanos) {
            dueNanos += periodNanos;
            topic.publish(maker.get());
        }
    }

    private void skipTo(long nowNanos) {
        if (dueNanos <= nowNanos) {
            dueNanos += ((nowNanos - dueNanos) / periodNanos + 1) * periodNanos;
        }
    }

    /** The time of the next message; never if nothing receives it. */
    long dueNanos() {
        return isSilent || !topic.hasSubscribers() ? Long.MAX_VALUE : dueNanos;
    }
}
