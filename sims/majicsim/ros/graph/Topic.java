package majicsim.ros.graph;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import majicsim.ros.message.MessageType;
import org.jspecify.annotations.Nullable;

/**
 * One topic: its type, the nodes at both ends, and what was published last if that is kept. Guarded by the lab's lock.
 */
public final class Topic {
    private final String name;
    private final MessageType type;
    private final Map<String, Integer> publishers = new LinkedHashMap<>();
    private final Map<TopicListener, String> subscribers = new LinkedHashMap<>();
    private @Nullable ObjectNode latched;

    Topic(String name, MessageType type) {
        this.name = name;
        this.type = type;
    }

    /**
     * Its name.
     *
     * @return absolute, as {@code /odom}
     */
    public String name() {
        return name;
    }

    /**
     * Its type.
     *
     * @return the one with which it was made
     */
    public MessageType type() {
        return type;
    }

    /**
     * Registers one publisher of a node.
     *
     * @param node its name
     */
    public void addPublisher(String node) {
        publishers.merge(node, 1, Integer::sum);
    }

    /**
     * Removes one publisher of a node.
     *
     * @param node its name
     */
    public void removePublisher(String node) {
        publishers.computeIfPresent(node, (name, count) -> count > 1 ? count - 1 : null);
    }

    /**
     * Registers a subscriber, which receives the kept message at once.
     *
     * @param node the name of its node
     * @param listener receives all messages from now on
     */
    public void subscribe(String node, TopicListener listener) {
        subscribers.put(listener, node);
        if (latched != null) {
            listener.published(latched);
        }
    }

    /**
     * Removes a subscriber; without effect if it is none.
     *
     * @param listener as it was registered
     */
    public void unsubscribe(TopicListener listener) {
        subscribers.remove(listener);
    }

    /**
     * Whether a message published now would be received; a publisher need not make one otherwise.
     *
     * @return true with at least one subscriber
     */
    public boolean hasSubscribers() {
        return !subscribers.isEmpty();
    }

    /**
     * Publishes a message.
     *
     * @param message not changed afterwards
     */
    public void publish(ObjectNode message) {
        for (TopicListener listener : List.copyOf(subscribers.keySet())) {
            listener.published(message);
        }
    }

    /**
     * Publishes a message and keeps it for later subscribers.
     *
     * @param message not changed afterwards
     */
    public void latch(ObjectNode message) {
        latched = message;
        publish(message);
    }

    /**
     * What was kept for later subscribers.
     *
     * @return null if nothing was
     */
    public @Nullable ObjectNode latched() {
        return latched;
    }

    /**
     * The nodes that publish it.
     *
     * @return names, each once
     */
    public List<String> publishers() {
        return List.copyOf(publishers.keySet());
    }

    /**
     * The nodes that subscribe to it.
     *
     * @return names, each once
     */
    public List<String> subscribers() {
        return new ArrayList<>(Set.copyOf(subscribers.values()));
    }

    /** Whether the network still has it. */
    boolean isAlive() {
        return !publishers.isEmpty() || !subscribers.isEmpty();
    }
}
