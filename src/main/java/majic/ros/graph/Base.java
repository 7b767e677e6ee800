package majic.ros.graph;

import org.jspecify.annotations.Nullable;

/**
 * A robot that can be driven. Immutable.
 *
 * @param namespace the beginning of the names of its topics, as {@code /robot1}; empty for a robot without one
 * @param command the topic of its velocity commands
 * @param commandType {@code geometry_msgs/Twist} or {@code geometry_msgs/TwistStamped}
 * @param odometry the topic of its odometry; null if it has none
 */
public record Base(
        String namespace,
        String command,
        String commandType,
        @Nullable String odometry) {
    /** The types of velocity commands, with two parts. */
    public static final String TWIST = "geometry_msgs/Twist";

    /** The same with a header. */
    public static final String TWIST_STAMPED = "geometry_msgs/TwistStamped";

    /** The type of odometry, with two parts. */
    public static final String ODOMETRY = "nav_msgs/Odometry";

    /** Returns whether a text of an address means this robot: its namespace, or one of its two topics. */
    boolean isNamed(String name) {
        String absolute = name.startsWith("/") ? name : "/" + name;
        return absolute.equals(namespace.isEmpty() ? "/" : namespace)
                || absolute.equals(command)
                || absolute.equals(odometry);
    }

    /** Returns the part of an address that means this robot and no other one. */
    String inAddress() {
        return namespace.isEmpty() ? "?base=" + command : namespace;
    }

    @Override
    public String toString() {
        return command + (odometry == null ? " without odometry" : " with " + odometry);
    }
}
