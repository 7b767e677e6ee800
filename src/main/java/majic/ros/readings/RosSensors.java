package majic.ros.readings;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * The sensors of one robot, found by the types of the topics. Immutable. With several topics of one type, the shortest
 * name is taken: sensors that are derived from others have longer ones.
 *
 * @param scans of laser scanners, the one to be shown first
 * @param ranges of sonars and other single beams, in the order of their names
 * @param battery with the charge or the voltage; the core sensors of a Kobuki if it has no other
 * @param imu of an inertial unit
 * @param joints of wheels and arms
 * @param slidingJoints the names of the joints that slide; the others turn
 * @param hazards of a Create 3
 * @param contacts of a Kobuki or a TurtleBot3
 * @param cameras with compressed pictures, the one to be shown first; colour before infrared, no depth
 * @param fixedFrames where sensors are on the robot
 */
public record RosSensors(
        List<RosTopic> scans,
        List<RosTopic> ranges,
        Optional<RosTopic> battery,
        Optional<RosTopic> imu,
        Optional<RosTopic> joints,
        Set<String> slidingJoints,
        Optional<RosTopic> hazards,
        List<RosTopic> contacts,
        List<RosTopic> cameras,
        Optional<RosTopic> fixedFrames) {
    /** The last part of the type of all that a Kobuki or a TurtleBot3 measures itself. */
    static final String CORE_SENSORS = "SensorState";

    /** The last part of the type of the batteries of a Spot. */
    static final String SPOT_BATTERIES = "BatteryStateArray";

    /** A robot without sensors. */
    public static final RosSensors NONE = of(Map.of(), "");

    /** Keeps copies of the lists. */
    public RosSensors {
        scans = List.copyOf(scans);
        ranges = List.copyOf(ranges);
        slidingJoints = Set.copyOf(slidingJoints);
        contacts = List.copyOf(contacts);
        cameras = List.copyOf(cameras);
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
                finder.all("sensor_msgs/LaserScan"::equals).stream()
                        .sorted(Finder.SIMPLEST)
                        .toList(),
                finder.all("sensor_msgs/Range"::equals),
                finder.best("sensor_msgs/BatteryState"::equals)
                        .or(() -> finder.best(("spot_msgs/" + SPOT_BATTERIES)::equals))
                        .or(() -> finder.best(RosSensors::isKobukiCore)),
                finder.best("sensor_msgs/Imu"::equals),
                finder.best("sensor_msgs/JointState"::equals),
                Set.of(),
                finder.best("irobot_create_msgs/HazardDetectionVector"::equals),
                finder.all(RosSensors::isContact),
                CameraTopics.bestFirst(finder.all("sensor_msgs/CompressedImage"::equals)),
                finder.all("tf2_msgs/TFMessage"::equals).stream()
                        .filter(topic -> topic.name().endsWith("/tf_static"))
                        .min(Finder.SIMPLEST));
    }

    private static boolean isContact(String type) {
        return type.equals("turtlebot3_msgs/" + CORE_SENSORS)
                || isKobukiCore(type)
                || type.matches("kobuki_(msgs|ros_interfaces)/(Bumper|Cliff|WheelDrop)Event");
    }

    private static boolean isKobukiCore(String type) {
        return type.equals("kobuki_msgs/" + CORE_SENSORS) || type.equals("kobuki_ros_interfaces/" + CORE_SENSORS);
    }

    /**
     * Returns the scanner that is shown and gives the distances.
     *
     * @return the first of the scanners; empty for a robot without one
     */
    public Optional<RosTopic> scan() {
        return scans.stream().findFirst();
    }

    /**
     * Returns the camera that is shown.
     *
     * @return the first of the cameras; empty for a robot without one
     */
    public Optional<RosTopic> camera() {
        return cameras.stream().findFirst();
    }

    /**
     * Returns the same sensors with another camera first.
     *
     * @param name its topic; what follows the name of the picture, such as {@code /compressed}, may be left out
     * @return empty if none of the cameras has that name
     */
    public Optional<RosSensors> withCamera(String name) {
        return CameraTopics.find(cameras, name).map(first -> {
            List<RosTopic> reordered = new ArrayList<>(cameras);
            reordered.remove(first);
            reordered.add(0, first);
            return new RosSensors(
                    scans, ranges, battery, imu, joints, slidingJoints, hazards, contacts, reordered, fixedFrames);
        });
    }

    /**
     * Returns the same sensors with joints that slide.
     *
     * @param names those of the joints
     * @return the sensors
     */
    public RosSensors withSlidingJoints(Set<String> names) {
        return new RosSensors(scans, ranges, battery, imu, joints, names, hazards, contacts, cameras, fixedFrames);
    }

    /** Looks for the topics of one robot. */
    private record Finder(Map<String, String> topics, String namespace) {
        static final Comparator<RosTopic> SIMPLEST = Comparator.<RosTopic>comparingInt(
                        topic -> topic.name().split("/").length)
                .thenComparingInt(topic -> topic.name().length());

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
            return all(type).stream().min(SIMPLEST);
        }
    }
}
