package majic.shared.broker;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/** The subscriptions of one connection, and the handlers of their messages. Thread-safe. */
final class TopicHandlers {
    private static final System.Logger LOG = System.getLogger(TopicHandlers.class.getName());

    private final Map<String, Subscription> byFilter = new ConcurrentHashMap<>();

    /** Those whose filters have wildcards: only these have to be compared with each topic. */
    private final Map<String, Subscription> withWildcards = new ConcurrentHashMap<>();

    /**
     * One subscription.
     *
     * @param filter as it was subscribed to
     * @param topics that it is for
     * @param quality the highest quality of service of the delivery
     * @param handler handles the messages
     */
    record Subscription(String filter, TopicFilter topics, Quality quality, BrokerConnection.Handler handler) {}

    /**
     * Adds a subscription, or replaces that of the same filter.
     *
     * @throws IllegalArgumentException if the filter is wrong
     */
    Subscription add(String filter, Quality quality, BrokerConnection.Handler handler) {
        Subscription added = new Subscription(filter, new TopicFilter(filter), quality, handler);
        byFilter.put(filter, added);
        if (added.topics.hasWildcards()) {
            withWildcards.put(filter, added);
        }
        return added;
    }

    /** Removes the subscription of a filter; returns whether there was one. */
    boolean remove(String filter) {
        withWildcards.remove(filter);
        return byFilter.remove(filter) != null;
    }

    /** Removes a subscription unless another one has replaced it. */
    void remove(Subscription refused) {
        withWildcards.remove(refused.filter, refused);
        byFilter.remove(refused.filter, refused);
    }

    /** Returns all subscriptions, in no order. */
    Iterable<Subscription> all() {
        return byFilter.values();
    }

    /** Returns whether a message on a topic has a handler. */
    boolean hasHandler(String topic) {
        if (byFilter.containsKey(topic)) {
            return true;
        }
        for (Subscription subscription : withWildcards.values()) {
            if (subscription.topics.matches(topic)) {
                return true;
            }
        }
        return false;
    }

    /** Passes a message to the handlers whose filters it matches; what they throw is logged. */
    void dispatch(BrokerMessage message) {
        pass(message, byFilter.get(message.topic()));
        for (Subscription subscription : withWildcards.values()) {
            if (subscription.topics.matches(message.topic())) {
                pass(message, subscription);
            }
        }
    }

    private static void pass(BrokerMessage message, @Nullable Subscription to) {
        if (to != null) {
            guarded("handling a message on " + message.topic(), () -> to.handler.received(message));
        }
    }

    /** Runs a task on the thread of a connection; what it throws is logged and ends nothing. */
    static void guarded(String what, Runnable task) {
        try {
            task.run();
        } catch (RuntimeException | LinkageError | StackOverflowError | AssertionError e) {
            LOG.log(Level.ERROR, what, e);
        }
    }
}
