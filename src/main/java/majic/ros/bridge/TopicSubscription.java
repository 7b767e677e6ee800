package majic.ros.bridge;

/**
 * What to subscribe to, and how often. Immutable. All subscriptions of one connection to one topic share its stream,
 * which has the least of their throttles.
 *
 * @param topic its absolute name, as {@code /odom}
 * @param type as rosapi names it: {@code nav_msgs/Odometry} in ROS 1, {@code nav_msgs/msg/Odometry} in ROS 2
 * @param throttleMs the least time between two messages, ms; 0 for all of them
 * @param queueLength how many messages the server keeps while the throttle holds them back; with 1 the newest one
 *     always arrives
 * @param binary whether messages come as CBOR, which is smaller. Servers send nothing then of types with an array of
 *     fixed length, as odometry has, or with texts in an array
 */
public record TopicSubscription(String topic, String type, int throttleMs, int queueLength, boolean binary) {
    /** So long after the first message no other one comes, ms. */
    private static final int ONCE_MS = 60_000;

    /** Refuses negative numbers and a name that is not absolute. */
    public TopicSubscription {
        if (!topic.startsWith("/")) {
            throw new IllegalArgumentException("the name of a topic begins with a slash: " + topic);
        }
        if (throttleMs < 0 || queueLength < 0) {
            throw new IllegalArgumentException("negative throttle or queue of " + topic);
        }
    }

    /**
     * A subscription to the newest messages, as JSON.
     *
     * @param topic its absolute name
     * @param type as rosapi names it
     * @param throttleMs the least time between two messages, ms
     */
    public TopicSubscription(String topic, String type, int throttleMs) {
        this(topic, type, throttleMs, 1, false);
    }

    /**
     * Returns the subscription to one message, which ends by unsubscribing.
     *
     * @return of the same topic
     */
    public TopicSubscription once() {
        return new TopicSubscription(topic, type, ONCE_MS, 1, binary);
    }
}
