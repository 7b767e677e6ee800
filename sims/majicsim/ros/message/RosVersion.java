package majicsim.ros.message;

/** The two versions of ROS, which differ in the names of types and of the parts of a time. */
public enum RosVersion {
    /** ROS 1: {@code geometry_msgs/Twist}, {@code secs} and {@code nsecs}, headers with {@code seq}. */
    ROS1("/", "secs", "nsecs"),
    /** ROS 2: {@code geometry_msgs/msg/Twist}, {@code sec} and {@code nanosec}. */
    ROS2("/msg/", "sec", "nanosec");

    private final String separator;
    private final String seconds;
    private final String nanoseconds;

    RosVersion(String separator, String seconds, String nanoseconds) {
        this.separator = separator;
        this.seconds = seconds;
        this.nanoseconds = nanoseconds;
    }

    /**
     * The full name of a message type.
     *
     * @param plain package and name, as {@code geometry_msgs/Twist}
     * @return as rosapi reports it
     */
    public String messageName(String plain) {
        return plain.replaceFirst("/", separator);
    }

    /**
     * The name that the bridge gives to the request or response of a service in its messages.
     *
     * @param plain package and name, as {@code std_srvs/TriggerRequest}
     * @return the same on ROS 1, {@code std_srvs/Trigger_Request} on ROS 2
     */
    String partName(String plain) {
        return this == ROS1
                ? plain
                : plain.replaceFirst("^rosapi/", "rosapi_msgs/").replaceFirst("(Request|Response)$", "_$1");
    }

    /**
     * The full name of a service type; those of rosapi are in another package with ROS 2.
     *
     * @param plain package and name, as {@code std_srvs/Trigger}
     * @return as rosapi reports it
     */
    public String serviceName(String plain) {
        return this == ROS1
                ? plain
                : plain.replaceFirst("^rosapi/", "rosapi_msgs/").replaceFirst("/", "/srv/");
    }

    String seconds() {
        return seconds;
    }

    String nanoseconds() {
        return nanoseconds;
    }
}
