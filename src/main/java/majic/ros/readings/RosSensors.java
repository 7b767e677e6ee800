package majic.ros.readings;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The sensors of one robot, found by the types of the topics. Immutable. With several topics of one type, the shortest name
 * is taken: sensors that are derived from others have longer ones.
 *
 * @param scan of a laser scanner
 * @param ranges of sonars and other single beams, in the order of their names
 * @param battery with the charge or the voltage
 * @param imu of an inertial unit
 * @param joints of wheels and arms
 * @param hazards of a Create 3
 * @param contacts of a Kobuki or a TurtleBot3
 * @param camera with compressed pictures
 * @param fixedFrames where sensors are on the robot
 */
public record RosSensors(
        Optional<RosTopic> scan,
        List<RosTopic> ranges,
        Optional<RosTopic> battery,
        Optional<RosTopic> imu,
        Optional<RosTopic> joints,
        Optional<RosTopic> hazards,
        List<RosTopic> contacts,
        Optional<RosTopic> camera,
        Optional<RosTopic> fixedFrames) {
    /** A robot without sensors. */
    public static final RosSensors NONE = of(Map.of(), "");

    /** Keeps copies of the lists. */
    public RosSensors {
        ranges = List.copyOf(ranges);
        contacts = List.copyOf(contacts);
    }

    /**
     * Finds the sensors of a robot.
     *
     * @param topics the types of all topics by their names
     * @param namespace of the robot, such as {@code /robot1}; empty for a robot without. The topics of a robot with a
     *     namespace are those in it; only if it has none of a type, one that is in no namespace
     * @return what was found
     */
    public static RosSensors of(Map<String, String> topics, String namespace) {
        Finder finder = new Finder(topics, namespace);
        return new RosSensors(
                finder.best("sensor_msgs/LaserScan"::equals),
                finder.all("sensor_msgs/Range"::equals),
                finder.best("sensor_msgs/BatteryState"::equals),
                finder.best("sensor_msgs/Imu"::equals),
                finder.best("sensor_msgs/JointState"::equals),
                finder.best("irobot_create_msgs/HazardDetectionVector"::equals),
                finder.all(RosSensors::isContact),
                finder.best(
                        "sensor_msgs/CompressedImage",
                        name -> !name.toLowerCase(Locale.ROOT).contains("depth")),
                finder.best("tf2_msgs/TFMessage", name -> name.endsWith("/tf_static")));
    }

    private static boolean isContact(String type) {
        return type.equals("turtlebot3_msgs/SensorState")
                || type.matches("kobuki_(msgs|ros_interfaces)/(Bumper|Cliff|WheelDrop)Event");
    }

    /** Looks for the topics of one robot. */
    private record Finder(Map<String, String> topics, String namespace) {
        List<RosTopic> all(Predicate<String> type) {
            List<RosTopic> found = topics.entrySet().stream()
                    .filter(topic -> type.test(RosTopic.plainType(topic.getValue())))
                    .map(topic -> new RosTopic(topic.getKey(), topic.getValue()))
                    .sorted(Comparator.comparing(RosTopic::name))
                    .toList();
            List<RosTopic> own = found.stream()
                    .filter(topic -> topic.name().startsWith(namespace + "/"))
                    .toList();
            return own.isEmpty()
                    ? found.stream().filter(Finder::isInNoNamespace).toList()
                    : own;
        }

        private static boolean isInNoNamespace(RosTopic topic) {
            return topic.name().lastIndexOf('/') == 0;
        }

        Optional<RosTopic> best(Predicate<String> type) {
            return shortest(all(type));
        }

        Optional<RosTopic> best(String type, Predicate<String> name) {
            return shortest(all(type::equals).stream()
                    .filter(topic -> name.test(topic.name()))
                    .toList());
        }

        private static Optional<RosTopic> shortest(List<RosTopic> topics) {
            return topics.stream()
                    .min(Comparator.<RosTopic>comparingInt(topic -> topic.name().split("/").length)
                            .thenComparingInt(topic -> topic.name().length()));
        }
    }
}
