package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.ServiceReply;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.RosVersion;
import majicsim.ros.options.RosOptions;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A TurtleBot3 Burger: its body in the room, and its nodes in a ROS network. It neither checks nor notices whether a
 * client is connected. Guarded by the lab's lock.
 */
public final class TurtleBot3 {
    /** The radius of the disc that represents its body, mm; it turns about its centre. */
    public static final double RADIUS_MM = 100;

    private static final long MS = 1_000_000;
    private static final long FAST_NANOS = 32 * MS;
    private static final long IMU_NANOS = 12 * MS;
    private static final long SCAN_NANOS = 200 * MS;
    private static final long BATTERY_NANOS = 200 * MS;
    private static final double NANOS = 1e9;

    private static final String DESCRIPTION = """
            <?xml version="1.0"?>
            <robot name="turtlebot3_burger">
              <link name="base_link"/>
              <link name="wheel_left_link"/>
              <link name="wheel_right_link"/>
              <joint name="wheel_left_joint" type="continuous">
                <parent link="base_link"/>
                <child link="wheel_left_link"/>
                <axis xyz="0 0 1"/>
              </joint>
              <joint name="wheel_right_joint" type="continuous">
                <parent link="base_link"/>
                <child link="wheel_right_link"/>
                <axis xyz="0 0 1"/>
              </joint>
            </robot>
            """;

    private final Body body;
    private final RosNetwork network;
    private final RosOptions options;
    private final String namespace;
    private final String node;
    private final BurgerDrive drive;
    private final WheelOdometry odometry = new WheelOdometry();
    private final BurgerSensors sensors;
    private final LaserScanner laser;
    private final List<PeriodicTopic> topics = new ArrayList<>();
    private final @Nullable Navigation navigation;

    /**
     * Puts the robot into the room and starts its nodes.
     *
     * @param world the room
     * @param body its body, not yet in the room
     * @param noise of its wheels and sensors
     * @param network its computer
     * @param options its kind
     * @param namespace before its names; empty for none
     * @throws IllegalArgumentException if the body does not fit there
     */
    public TurtleBot3(World world, Body body, Noise noise, RosNetwork network, RosOptions options, String namespace) {
        world.add(body);
        this.body = body;
        this.network = network;
        this.options = options;
        this.namespace = namespace;
        this.node = namespace + (options.version() == RosVersion.ROS1 ? "/turtlebot3_core" : "/turtlebot3_node");
        drive = new BurgerDrive(body, options.timeoutS(), noise.fork("wheels"));
        sensors = new BurgerSensors(network.clock(), options.version(), body, odometry, noise.fork("imu"));
        laser = new LaserScanner(world, body, noise.fork("laser"));
        network.nodes().add(node);
        Topic commands = startCommands();
        startTopics(world);
        navigation =
                options.hasNavigation() ? new Navigation(network, options, namespace, commands, odometry, body) : null;
    }

    private Topic startCommands() {
        String type = options.isStamped() ? "geometry_msgs/TwistStamped" : "geometry_msgs/Twist";
        Topic commands = network.topics().at(named("/cmd_vel"), network.types().get(type));
        commands.subscribe(node, new VelocityInput(drive, network.clock(), options));
        return commands;
    }

    private void startTopics(World world) {
        add("/odom", "nav_msgs/Odometry", FAST_NANOS, sensors::odometry);
        add("/tf", "tf2_msgs/TFMessage", FAST_NANOS, sensors::baseTransform);
        add("/joint_states", "sensor_msgs/JointState", FAST_NANOS, sensors::joints);
        add("/imu", "sensor_msgs/Imu", IMU_NANOS, sensors::imu);
        add(
                "/scan",
                "sensor_msgs/LaserScan",
                SCAN_NANOS,
                () -> laser.scan(network.clock().nanos()));
        add("/battery_state", "sensor_msgs/BatteryState", BATTERY_NANOS, sensors::battery);
        add("/sensor_state", "turtlebot3_msgs/SensorState", FAST_NANOS, sensors::board);
        if (options.hasCamera()) {
            WallCamera camera = new WallCamera(world, body);
            add(
                    "/camera/image/compressed",
                    "sensor_msgs/CompressedImage",
                    SCAN_NANOS,
                    () -> camera.picture(network.clock().nanos()));
        }
        describe();
        network.advertise(node, named("/tf_static"), "tf2_msgs/TFMessage").latch(sensors.mounting());
        if (options.version() == RosVersion.ROS2) {
            network.offer(node, named("/motor_power"), "std_srvs/SetBool", this::motorPower);
            network.offer(node, named("/sound"), "turtlebot3_msgs/Sound", (request, reply) -> reply.succeed(done()));
        }
    }

    /** Its description in the format URDF, with the joints alone. In ROS 2 a parameter belongs to its node. */
    private void describe() {
        String publisher = named("/robot_state_publisher");
        network.nodes().add(publisher);
        String name =
                options.version() == RosVersion.ROS1 ? named("/robot_description") : publisher + ":robot_description";
        network.parameters().put(name, TextNode.valueOf(DESCRIPTION).toString());
    }

    /** Without power the wheels hold still and commands have no effect. */
    private void motorPower(ObjectNode request, ServiceReply reply) {
        drive.power(request.path("data").asBoolean());
        reply.succeed(done());
    }

    private static ObjectNode done() {
        return Messages.empty().put("success", true);
    }

    private void add(String name, String type, long periodNanos, Supplier<ObjectNode> maker) {
        topics.add(new PeriodicTopic(network.advertise(node, named(name), type), periodNanos, maker));
    }

    private String named(String name) {
        return namespace + name;
    }

    /**
     * Its body in the world.
     *
     * @return as it was given
     */
    public Body body() {
        return body;
    }

    /**
     * Lets time pass; the world has just been stepped, and the network's clock advanced.
     *
     * @param seconds lab time
     */
    public void step(double seconds) {
        drive.step(seconds);
        odometry.step(drive.measuredLeft(), drive.measuredRight(), seconds);
        long now = network.clock().elapsedNanos();
        topics.forEach(topic -> topic.step(now));
        if (navigation != null) {
            navigation.step(now);
        }
    }

    /**
     * Whether it publishes a topic at a rate.
     *
     * @param topic its name
     * @return true for a topic that {@link #silence} and {@link #rate} take
     */
    public boolean publishes(String topic) {
        return topics.stream().anyMatch(one -> one.name().equals(topic));
    }

    /**
     * Stops publishing a topic, as a sensor that has failed, or goes on. A fault.
     *
     * @param topic its name
     * @param silent whether it is silent from now on
     */
    public void silence(String topic, boolean silent) {
        of(topic).silence(silent);
    }

    /**
     * Publishes a topic at another rate.
     *
     * @param topic its name
     * @param hertz messages a second, above 0; the lab's steps of 4 ms bring several at once above 250
     */
    public void rate(String topic, double hertz) {
        of(topic).period(Math.round(NANOS / hertz), network.clock().elapsedNanos());
    }

    private PeriodicTopic of(String name) {
        return topics.stream()
                .filter(topic -> topic.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("the robot does not publish " + name));
    }

    /**
     * Makes most readings of its laser unusable. A fault.
     *
     * @param spoilt whether it is so from now on
     */
    public void spoilScans(boolean spoilt) {
        laser.spoil(spoilt);
    }

    /**
     * Rejects the goals of its navigation. A fault.
     *
     * @param rejects whether it is so from now on
     */
    public void rejectGoals(boolean rejects) {
        if (navigation != null) {
            navigation.faults().reject(rejects);
        }
    }

    /**
     * For how long nothing will change but the time.
     *
     * @return lab time, ns; 0 while it moves
     */
    public long restNanos() {
        if (!drive.isResting()) {
            return 0;
        }
        long due = navigation == null ? Long.MAX_VALUE : navigation.dueNanos();
        for (PeriodicTopic topic : topics) {
            due = Math.min(due, topic.dueNanos());
        }
        return Math.max(0, due - network.clock().elapsedNanos());
    }
}
