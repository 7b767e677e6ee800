package majicsim.ros.options;

import java.util.function.Consumer;
import majicsim.ros.message.RosVersion;

/**
 * The kind of a simulated ROS robot and of its rosbridge server. Immutable.
 *
 * @param version of ROS
 * @param isStamped whether its velocity commands are TwistStamped, as from Jazzy on; otherwise Twist
 * @param timeoutS after which time without command the base stops, s; 0 for never
 * @param blocksConnection whether a pending service or goal holds up what came later on the same connection, as
 *     rosbridge up to 2.1.0 does on ROS 2 (sheet 1, rule 5)
 * @param hasNavigation whether it drives to goals: move_base on ROS 1, navigate_to_pose on ROS 2
 * @param secret with which clients must authenticate; empty if they need not (ROS 1 alone)
 * @param namespace before the names of the robot's topics, as {@code /tb3}; empty for none
 * @param robots how many robots are behind the bridge, 1 to {@value #MOST_ROBOTS}; several have a namespace each
 * @param hasCamera whether the robots have a camera
 * @param serverNamespace in which the rosbridge server and rosapi run, as {@code /tb3}; empty for none (ROS 2 alone)
 */
public record RosOptions(
        RosVersion version,
        boolean isStamped,
        double timeoutS,
        boolean blocksConnection,
        boolean hasNavigation,
        String secret,
        String namespace,
        int robots,
        boolean hasCamera,
        String serverNamespace) {
    /** How many robots a bridge has at most. */
    public static final int MOST_ROBOTS = 9;

    /** The time-out of the TurtleBot3's firmware for ROS 1, s (sheet 8). */
    public static final double FIRMWARE_TIMEOUT_S = 0.5;

    private static final double LONGEST_TIMEOUT_S = 60;

    /**
     * Checks them.
     *
     * @throws IllegalArgumentException if something is outside its range, or does not exist in this version of ROS; the
     *     message names it
     */
    public RosOptions {
        if (!(timeoutS >= 0 && timeoutS <= LONGEST_TIMEOUT_S)) {
            throw new IllegalArgumentException("timeout must be 0 (none) to 60 s, not " + timeoutS);
        }
        if (!secret.isEmpty() && version != RosVersion.ROS1) {
            throw new IllegalArgumentException("auth exists with ROS 1 only");
        }
        if (robots < 1 || robots > MOST_ROBOTS) {
            throw new IllegalArgumentException("robots must be 1 to " + MOST_ROBOTS + ", not " + robots);
        }
        requireWord("namespace", namespace);
        requireWord("server", serverNamespace);
        if (!serverNamespace.isEmpty() && version != RosVersion.ROS2) {
            throw new IllegalArgumentException("server exists with ROS 2 only");
        }
    }

    private static void requireWord(String what, String namespace) {
        if (!namespace.isEmpty() && !namespace.matches("/[A-Za-z][A-Za-z0-9_]*")) {
            throw new IllegalArgumentException(
                    what + " must be a word of letters, digits and _, not '" + namespace + "'");
        }
    }

    /**
     * A TurtleBot3 Burger as its makers' software runs it: with ROS 1 it stops 0.5 s after the last command, with ROS 2
     * it drives on.
     *
     * @param version of ROS
     * @return the options
     */
    public static RosOptions of(RosVersion version) {
        boolean isRos2 = version == RosVersion.ROS2;
        return new RosOptions(version, false, isRos2 ? 0 : FIRMWARE_TIMEOUT_S, isRos2, true, "", "", 1, false, "");
    }

    /**
     * Parses a model: 1 or 2, then the differences of this robot behind plus signs, in any case.
     *
     * @param model such as {@code 2+stamped+timeout=0.5}
     * @return the options
     * @throws IllegalArgumentException if there is no such robot; the message names the wrong word and the right ones
     */
    public static RosOptions parse(String model) {
        return RosModelParser.parse(model);
    }

    /**
     * The same robot with stamped commands.
     *
     * @return the options
     */
    public RosOptions stamped() {
        return with(copy -> copy.isStamped = true);
    }

    /**
     * The same robot with another time-out.
     *
     * @param seconds 0 (none) to 60
     * @return the options
     * @throws IllegalArgumentException if it is outside
     */
    public RosOptions withTimeout(double seconds) {
        return with(copy -> copy.timeoutS = seconds);
    }

    /**
     * The same robot behind a bridge that starts a thread for each service and goal, as from 2.2.0 on.
     *
     * @return the options
     */
    public RosOptions unblocked() {
        return with(copy -> copy.blocksConnection = false);
    }

    /**
     * The same robot without navigation.
     *
     * @return the options
     */
    public RosOptions withoutNavigation() {
        return with(copy -> copy.hasNavigation = false);
    }

    /**
     * The same robot behind a bridge that demands authentication.
     *
     * @param newSecret shared with the clients
     * @return the options
     * @throws IllegalArgumentException with ROS 2
     */
    public RosOptions withSecret(String newSecret) {
        return with(copy -> copy.secret = newSecret);
    }

    /**
     * The same robot with its names in a namespace.
     *
     * @param word without slash
     * @return the options
     * @throws IllegalArgumentException if it is not a word
     */
    public RosOptions withNamespace(String word) {
        return with(copy -> copy.namespace = "/" + word);
    }

    /**
     * Several such robots behind one bridge.
     *
     * @param count 1 to {@value #MOST_ROBOTS}
     * @return the options
     * @throws IllegalArgumentException if it is outside
     */
    public RosOptions withRobots(int count) {
        return with(copy -> copy.robots = count);
    }

    /**
     * The same robot with a camera.
     *
     * @return the options
     */
    public RosOptions withCamera() {
        return with(copy -> copy.hasCamera = true);
    }

    /**
     * The same robot behind a server in a namespace, as rosbridge allows it from 2.2.0 on.
     *
     * @param word without slash
     * @return the options
     * @throws IllegalArgumentException with ROS 1, or if it is not a word
     */
    public RosOptions withServerNamespace(String word) {
        return with(copy -> copy.serverNamespace = "/" + word);
    }

    /**
     * The prefix of the names of one robot.
     *
     * @param number of the robot, from 0
     * @return the namespace, for one of several {@code /tb3_0} behind it; empty for none
     */
    public String namespaceOf(int number) {
        return robots == 1 ? namespace : namespace + "/tb3_" + number;
    }

    private RosOptions with(Consumer<Copy> change) {
        Copy copy = new Copy(this);
        change.accept(copy);
        return copy.options();
    }

    /** The fields, to change some of them. */
    private static final class Copy {
        private RosVersion version;
        private boolean isStamped;
        private double timeoutS;
        private boolean blocksConnection;
        private boolean hasNavigation;
        private String secret;
        private String namespace;
        private int robots;
        private boolean hasCamera;
        private String serverNamespace;

        Copy(RosOptions from) {
            version = from.version;
            isStamped = from.isStamped;
            timeoutS = from.timeoutS;
            blocksConnection = from.blocksConnection;
            hasNavigation = from.hasNavigation;
            secret = from.secret;
            namespace = from.namespace;
            robots = from.robots;
            hasCamera = from.hasCamera;
            serverNamespace = from.serverNamespace;
        }

        RosOptions options() {
            return new RosOptions(
                    version,
                    isStamped,
                    timeoutS,
                    blocksConnection,
                    hasNavigation,
                    secret,
                    namespace,
                    robots,
                    hasCamera,
                    serverNamespace);
        }
    }
}
