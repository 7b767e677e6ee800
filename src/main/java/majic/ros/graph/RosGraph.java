package majic.ros.graph;

import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * The topics and nodes of a ROS system at the moment it was asked. Immutable.
 *
 * @param version 1 or 2
 * @param distribution its name in lower case, as {@code noetic} or {@code humble}; empty if it is not known
 * @param topics the type of each topic by the topic's absolute name, topics without publishers included
 * @param nodes the absolute names of the nodes
 */
public record RosGraph(int version, String distribution, Map<String, String> topics, SortedSet<String> nodes) {
    private static final String MESSAGE_PART = "/msg/";
    private static final String CLOCK = "/clock";

    /** Copies the collections. */
    public RosGraph {
        topics = new TreeMap<>(topics);
        nodes = new TreeSet<>(nodes);
    }

    /**
     * Returns whether it is ROS 2.
     *
     * @return false for ROS 1
     */
    public boolean isRos2() {
        return version == 2;
    }

    /**
     * Returns the name of a message type as this version of ROS writes it.
     *
     * @param type with two parts, as {@code nav_msgs/Odometry}
     * @return the same in ROS 1; {@code nav_msgs/msg/Odometry} in ROS 2
     */
    public String typeName(String type) {
        return isRos2() ? type.replaceFirst("/", MESSAGE_PART) : type;
    }

    /**
     * Returns the topics of a type.
     *
     * @param type with two parts, as {@code nav_msgs/Odometry}
     * @return absolute names in alphabetical order
     */
    public List<String> topicsOf(String type) {
        return topics.entrySet().stream()
                .filter(topic -> twoParts(topic.getValue()).equals(type))
                .map(Map.Entry::getKey)
                .toList();
    }

    /**
     * Returns the type of a topic.
     *
     * @param topic its absolute name
     * @return with two parts; null if there is no such topic
     */
    public @Nullable String typeOf(String topic) {
        String type = topics.get(topic);
        return type == null ? null : twoParts(type);
    }

    private static String twoParts(String type) {
        return type.replace(MESSAGE_PART, "/");
    }

    /**
     * Returns whether the stamps of messages are of a simulated time.
     *
     * @return whether a simulator publishes the time
     */
    public boolean hasSimulatedTime() {
        return topics.containsKey(CLOCK);
    }

    /**
     * Returns the version and distribution for messages.
     *
     * @return as {@code ROS 2 humble}
     */
    public String title() {
        return ("ROS " + version + " " + distribution).strip();
    }
}
