package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;

/**
 * An inertial measurement unit ({@code sensor_msgs/Imu}). Immutable. What the unit does not measure is empty.
 *
 * @param orientation against the unit's own reference, which need not be north
 * @param ratesDegPerSec how fast the robot turns around its axes; z counterclockwise positive
 * @param accelerations m/s² along the axes; z is about 9.8 at rest
 */
public record ImuMessage(
        Optional<Orientation> orientation, Optional<Vector> ratesDegPerSec, Optional<Vector> accelerations) {

    /**
     * Reads a message.
     *
     * @param message the content of a {@code sensor_msgs/Imu}
     * @return the readings
     * @throws UnusableMessage if the message has none of the three fields
     */
    public static ImuMessage from(JsonNode message) {
        if (!message.has("orientation") && !message.has("angular_velocity") && !message.has("linear_acceleration")) {
            throw new UnusableMessage("orientation, angular_velocity and linear_acceleration are absent");
        }
        return new ImuMessage(
                isMeasured(message, "orientation") ? orientation(message) : Optional.empty(),
                isMeasured(message, "angular_velocity")
                        ? Vector.from(message, "angular_velocity").map(Vector::toDegrees)
                        : Optional.empty(),
                isMeasured(message, "linear_acceleration")
                        ? Vector.from(message, "linear_acceleration")
                        : Optional.empty());
    }

    /** A covariance of −1 in the first place means that there is no such sensor. */
    private static boolean isMeasured(JsonNode message, String field) {
        return message.path(field + "_covariance").path(0).asDouble() != -1;
    }

    /** A quaternion of zeros is how some units say that they have no orientation. */
    private static Optional<Orientation> orientation(JsonNode message) {
        boolean zero = Vector.from(message, "orientation")
                .filter(vector -> vector.equals(Vector.ZERO)
                        && message.at("/orientation/w").asDouble() == 0)
                .isPresent();
        try {
            return zero ? Optional.empty() : Optional.of(Orientation.from(message, "orientation"));
        } catch (UnusableMessage e) {
            return Optional.empty();
        }
    }
}
