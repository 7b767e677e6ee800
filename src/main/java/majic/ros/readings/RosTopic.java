package majic.ros.readings;

import java.util.Set;
import majic.ros.bridge.TopicSubscription;

/**
 * A topic. Immutable.
 *
 * @param name absolute
 * @param type as rosapi names it, in the form of ROS 1 or of ROS 2
 */
public record RosTopic(String name, String type) {
    /** Types that servers can send as CBOR, and whose messages are mainly bytes (rosbridge sheet 3). */
    private static final Set<String> BINARY = Set.of(
            "sensor_msgs/Image", "sensor_msgs/CompressedImage", "sensor_msgs/PointCloud2", "nav_msgs/OccupancyGrid");

    /**
     * Returns a type without the difference between the two systems.
     *
     * @param type {@code sensor_msgs/LaserScan} or {@code sensor_msgs/msg/LaserScan}
     * @return the form of ROS 1
     */
    public static String plainType(String type) {
        return type.replaceFirst("^(\\w+)/msg/", "$1/");
    }

    /**
     * Returns the last part of the type.
     *
     * @return such as {@code LaserScan}
     */
    public String shortType() {
        return type.substring(type.lastIndexOf('/') + 1);
    }

    /**
     * Returns the type without the difference between the two systems.
     *
     * @return the form of ROS 1, as {@code sensor_msgs/LaserScan}
     */
    public String plainType() {
        return plainType(type);
    }

    /** Asks for its newest messages in the smallest form, no more often than each so many ms. */
    TopicSubscription each(int throttleMs) {
        return new TopicSubscription(name, type, throttleMs, 1, BINARY.contains(plainType()));
    }
}
