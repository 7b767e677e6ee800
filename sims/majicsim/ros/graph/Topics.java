package majicsim.ros.graph;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import majicsim.ros.message.MessageType;
import org.jspecify.annotations.Nullable;

/** All topics. A topic exists as long as it has a publisher or a subscriber. Guarded by the lab's lock. */
public final class Topics {
    private final Map<String, Topic> topics = new LinkedHashMap<>();
    private Predicate<String> hidden = name -> false;

    /** No topics yet. */
    Topics() {}

    /**
     * The topics that exist and are not hidden.
     *
     * @return in the order in which they were made
     */
    public List<Topic> all() {
        return topics.values().stream()
                .filter(topic -> topic.isAlive() && !hidden.test(topic.name()))
                .toList();
    }

    /**
     * A topic that exists.
     *
     * @param name absolute
     * @return null if there is none, or if it is hidden
     */
    public @Nullable Topic find(String name) {
        Topic topic = topics.get(name);
        return topic != null && topic.isAlive() && !hidden.test(name) ? topic : null;
    }

    /**
     * A topic, made if it does not exist.
     *
     * @param name absolute
     * @param type its type, if it is made
     * @return the topic; of another type if it existed before
     */
    public Topic at(String name, MessageType type) {
        Topic found = topics.get(name);
        if (found == null || !found.isAlive() && found.type() != type) {
            found = new Topic(name, type);
            topics.put(name, found);
        }
        return found;
    }

    /**
     * Hides topics from clients of the bridge, as if the robot did not have them. The robot still uses them. A fault.
     *
     * @param which chooses them by name
     */
    public void hide(Predicate<String> which) {
        hidden = which;
    }
}
