package majic.ros.graph;

import java.util.List;
import java.util.regex.Pattern;

/** Names of topics: which robot a topic belongs to, and how usual its name is. */
final class TopicNames {
    /**
     * Segments that name a part of a robot and not a robot: {@code /husky_velocity_controller/odom} belongs to the
     * robot without a namespace.
     */
    private static final Pattern PART =
            Pattern.compile(".*controller|.*mux|.*teleop|.*nav|platform|mobile_base|commands|input|output|odometry"
                    + "|base|navigation|.*smoother|.*_fake|.*_node");

    /** Command topics of robots without an entry in the table, the most usual one first. */
    private static final List<Pattern> COMMANDS = List.of(
            Pattern.compile("cmd_vel"),
            Pattern.compile("cmd_vel_stamped|cmd_vel_unstamped"),
            Pattern.compile("mobile_base/commands/velocity|cmd_vel_mux/input/teleop"),
            Pattern.compile(".*/cmd_vel"),
            Pattern.compile(".*cmd_vel.*"));

    /** Odometry topics of robots without an entry in the table, the most usual one first. */
    private static final List<Pattern> ODOMETRY = List.of(
            Pattern.compile("odometry/filtered|platform/odom/filtered"),
            Pattern.compile("odom"),
            Pattern.compile("odometry"),
            Pattern.compile(".*/odom|.*_odom|odom_.*"));

    private TopicNames() {}

    /** Returns the namespace of the robot that a topic belongs to; empty for none. */
    static String namespace(String topic) {
        String[] segments = topic.substring(1).split("/");
        StringBuilder namespace = new StringBuilder();
        for (int i = 0; i < segments.length - 1 && !PART.matcher(segments[i]).matches(); i++) {
            namespace.append('/').append(segments[i]);
        }
        return namespace.toString();
    }

    /** Returns how unusual a command topic is: 0 for the most usual name. */
    static int commandRank(String relative) {
        return rank(COMMANDS, relative);
    }

    /** Returns how unusual an odometry topic is: 0 for the most usual name. */
    static int odometryRank(String relative) {
        return rank(ODOMETRY, relative);
    }

    private static int rank(List<Pattern> usual, String relative) {
        for (int i = 0; i < usual.size(); i++) {
            if (usual.get(i).matcher(relative).matches()) {
                return i;
            }
        }
        return usual.size();
    }

    /** Returns a topic without its namespace and the slash behind it. */
    static String relative(String topic, String namespace) {
        return topic.substring(namespace.length() + 1);
    }
}
