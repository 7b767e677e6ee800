package majicsim.ros.robot;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import majicsim.ros.graph.RosClock;
import majicsim.ros.graph.TopicListener;
import majicsim.ros.message.RosVersion;
import majicsim.ros.options.RosOptions;

/** Takes velocity commands off their topic. On ROS 2 the base cuts speeds to steps of 0.01 (sheet 8). */
final class VelocityInput implements TopicListener {
    private static final double STEPS = 100;
    private static final double NANOS = 1e9;

    private final BurgerDrive drive;
    private final RosClock clock;
    private final RosOptions options;

    VelocityInput(BurgerDrive drive, RosClock clock, RosOptions options) {
        this.drive = drive;
        this.clock = clock;
        this.options = options;
    }

    @Override
    public void published(ObjectNode message) {
        if (!options.isStamped()) {
            take(message);
        } else if (!isTooOld(message.path("header").path("stamp").asLong())) {
            take(message.path("twist"));
        }
    }

    /** A stamped command older than the time-out is refused; no stamp counts as now (sheet 7). */
    private boolean isTooOld(long stampNanos) {
        double ageS = (clock.nanos() - stampNanos) / NANOS;
        return stampNanos != 0 && options.timeoutS() > 0 && ageS > options.timeoutS();
    }

    private void take(JsonNode twist) {
        drive.command(new Velocity(
                rounded(twist.path("linear").path("x").asDouble()),
                rounded(twist.path("angular").path("z").asDouble())));
    }

    /** The tolerance keeps 0.29, which is slightly less than 29 steps in binary, at 0.29. */
    private double rounded(double speed) {
        boolean cuts = options.version() == RosVersion.ROS2 && Double.isFinite(speed);
        return cuts ? (int) (speed * STEPS + Math.copySign(1e-9, speed)) / STEPS : speed;
    }
}
