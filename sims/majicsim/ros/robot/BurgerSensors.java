package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.graph.RosClock;
import majicsim.ros.message.RosVersion;
import majicsim.world.Body;
import majicsim.world.Contact;
import majicsim.world.Noise;

/** What the TurtleBot3's controller board measures: motion, battery, bumper. Makes messages. */
final class BurgerSensors {
    static final String BASE = "base_footprint";

    private static final String ODOM = "odom";
    private static final double GRAVITY = 9.81;
    private static final double GYRO_SIGMA = 0.002;
    private static final double FULL_VOLTS = 12.3;
    private static final double EMPTY_VOLTS = 11.0;
    private static final double VOLTS_PER_SEC = 0.00015;
    private static final double NOMINAL_VOLTS = 11.1;
    private static final double CAPACITY_AH = 1.8;
    private static final int BUMPER_FRONT = 1;
    private static final int BUMPER_BACK = 2;
    private static final double COUNTS_PER_RAD = 4096 / (2 * Math.PI);
    private static final double NANOS = 1e9;

    private final RosClock clock;
    private final RosVersion version;
    private final Body body;
    private final WheelOdometry odometry;
    private final Noise noise;

    BurgerSensors(RosClock clock, RosVersion version, Body body, WheelOdometry odometry, Noise noise) {
        this.clock = clock;
        this.version = version;
        this.body = body;
        this.odometry = odometry;
        this.noise = noise;
    }

    ObjectNode odometry() {
        ObjectNode message = Messages.stamped(clock.nanos(), ODOM).put("child_frame_id", BASE);
        ObjectNode pose = message.putObject("pose");
        pose.set("pose", Messages.pose(odometry));
        pose.set("covariance", Messages.diagonal(0.1, 0.1, 1e6, 1e6, 1e6, 0.2));
        ObjectNode twist = message.putObject("twist");
        twist.set("twist", Messages.twist(odometry.metresPerSec(), odometry.radPerSec()));
        twist.set("covariance", Messages.diagonal(0.1, 0.1, 1e6, 1e6, 1e6, 0.2));
        return message;
    }

    ObjectNode imu() {
        ObjectNode message = Messages.stamped(clock.nanos(), "imu_link");
        message.set("orientation", Messages.rotation(odometry.yaw()));
        message.set("orientation_covariance", Messages.diagonal(0.0025, 0.0025, 0.0025));
        message.set(
                "angular_velocity",
                Messages.vector(0, 0, Math.toRadians(body.turnDegPerSec()) + noise.gaussian(GYRO_SIGMA)));
        message.set("angular_velocity_covariance", Messages.diagonal(0.02, 0.02, 0.02));
        message.set("linear_acceleration", Messages.vector(0, 0, GRAVITY));
        message.set("linear_acceleration_covariance", Messages.diagonal(0.04, 0.04, 0.04));
        return message;
    }

    ObjectNode joints() {
        ObjectNode message = Messages.stamped(clock.nanos(), version == RosVersion.ROS1 ? BASE : "base_link");
        message.putArray("name").add("wheel_left_joint").add("wheel_right_joint");
        message.set("position", Messages.numbers(odometry.leftAngle(), odometry.rightAngle()));
        message.set("velocity", Messages.numbers(odometry.leftRadPerSec(), odometry.rightRadPerSec()));
        message.set("effort", Messages.numbers(0, 0));
        return message;
    }

    /** The percentage has the makers' odd scales: above 1 when full on ROS 1, 0 to 100 on ROS 2 (sheet 7). */
    ObjectNode battery() {
        double volts = volts();
        double percentage = version == RosVersion.ROS1
                ? volts / NOMINAL_VOLTS
                : 100 * Math.min(1, (volts - EMPTY_VOLTS) / (FULL_VOLTS - EMPTY_VOLTS));
        ObjectNode message = Messages.stamped(clock.nanos(), "")
                .put("voltage", volts)
                .put("design_capacity", CAPACITY_AH)
                .put("percentage", percentage)
                .put("present", true);
        for (String unknown : new String[] {"current", "charge", "capacity"}) {
            message.put(unknown, Double.NaN);
        }
        return message;
    }

    ObjectNode board() {
        return Messages.stamped(clock.nanos(), "")
                .put("bumper", bumper(body.contact()))
                .put("torque", true)
                .put("left_encoder", (int) (odometry.leftAngle() * COUNTS_PER_RAD))
                .put("right_encoder", (int) (odometry.rightAngle() * COUNTS_PER_RAD))
                .put("battery", volts());
    }

    ObjectNode baseTransform() {
        ObjectNode message = Messages.empty();
        ObjectNode transform = message.putArray("transforms").addObject();
        transform.setAll(Messages.stamped(clock.nanos(), ODOM));
        transform.put("child_frame_id", BASE);
        ObjectNode values = transform.putObject("transform");
        values.set("translation", Messages.vector(odometry.x(), odometry.y(), 0));
        values.set("rotation", Messages.rotation(odometry.yaw()));
        return message;
    }

    /** Where the devices are mounted on the base. */
    ObjectNode mounting() {
        ObjectNode message = Messages.empty();
        addFixed(message, BASE, "base_link", 0, 0.010);
        addFixed(message, "base_link", LaserScanner.FRAME, LaserScanner.AHEAD_M, LaserScanner.HEIGHT_M - 0.010);
        addFixed(message, "base_link", "imu_link", LaserScanner.AHEAD_M, 0.068);
        return message;
    }

    private void addFixed(ObjectNode message, String parent, String child, double ahead, double up) {
        ObjectNode transform = message.withArray("transforms").addObject();
        transform.setAll(Messages.stamped(clock.nanos(), parent));
        transform.put("child_frame_id", child);
        ObjectNode values = transform.putObject("transform");
        values.set("translation", Messages.vector(ahead, 0, up));
        values.set("rotation", Messages.rotation(0));
    }

    private double volts() {
        return Math.max(EMPTY_VOLTS, FULL_VOLTS - VOLTS_PER_SEC * clock.elapsedNanos() / NANOS);
    }

    private static int bumper(Contact contact) {
        if (!contact.touching()) {
            return 0;
        }
        return Math.abs(contact.directionDeg()) <= 90 ? BUMPER_FRONT : BUMPER_BACK;
    }
}
