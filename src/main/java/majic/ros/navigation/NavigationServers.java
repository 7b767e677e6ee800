package majic.ros.navigation;

import java.util.Collection;
import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import majic.ros.readings.RosTopic;

/**
 * The servers of a robot that pursue goals, by their absolute names. Immutable.
 *
 * @param moveBase of ROS 1, the beginning of the names of its topics, as {@code /move_base}
 * @param navigateToPose the action of Nav2, as {@code /navigate_to_pose}
 * @param dock the action with which a Create 3 docks
 * @param undock the action with which it leaves its dock
 */
public record NavigationServers(
        Optional<String> moveBase, Optional<String> navigateToPose, Optional<String> dock, Optional<String> undock) {
    /** A robot without navigation and dock. */
    public static final NavigationServers NONE =
            new NavigationServers(Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());

    private static final String GOAL = "/goal";

    /**
     * Finds the servers of a robot.
     *
     * @param topics the types of all topics by their names
     * @param actions the absolute names of the action servers of ROS 2; empty for ROS 1
     * @param namespace of the robot; empty for a robot without
     * @return what is there
     */
    public static NavigationServers of(Map<String, String> topics, Collection<String> actions, String namespace) {
        boolean create3 = topics.values().stream().anyMatch(type -> type.startsWith("irobot_create_msgs/"));
        return new NavigationServers(
                topics.entrySet().stream()
                        .filter(topic ->
                                RosTopic.plainType(topic.getValue()).equals("move_base_msgs/MoveBaseActionGoal"))
                        .map(Map.Entry::getKey)
                        .filter(name -> name.endsWith(GOAL) && name.startsWith(namespace + "/"))
                        .min(Comparator.comparingInt(String::length))
                        .map(name -> name.substring(0, name.length() - GOAL.length())),
                action(actions, namespace, "/navigate_to_pose"),
                create3 ? action(actions, namespace, "/dock") : Optional.empty(),
                create3 ? action(actions, namespace, "/undock") : Optional.empty());
    }

    private static Optional<String> action(Collection<String> actions, String namespace, String name) {
        return actions.stream()
                .filter(action -> action.startsWith(namespace + "/") && action.endsWith(name))
                .min(Comparator.comparingInt(String::length));
    }

    /**
     * Returns whether the robot drives to places.
     *
     * @return false if neither move_base nor Nav2 is there
     */
    public boolean canNavigate() {
        return moveBase.isPresent() || navigateToPose.isPresent();
    }
}
