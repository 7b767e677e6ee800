package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Three numbers along the axes x (ahead), y (left) and z (up). Immutable.
 *
 * @param x finite
 * @param y finite
 * @param z finite
 */
public record Vector(double x, double y, double z) {
    /** Three zeros. */
    public static final Vector ZERO = new Vector(0, 0, 0);

    /** Reads a {@code geometry_msgs/Vector3} or {@code Point}; empty if one of the numbers is not finite. */
    static Optional<Vector> from(JsonNode message, String path) {
        OptionalDouble x = Fields.optional(message, path + ".x");
        OptionalDouble y = Fields.optional(message, path + ".y");
        OptionalDouble z = Fields.optional(message, path + ".z");
        return x.isEmpty() || y.isEmpty() || z.isEmpty()
                ? Optional.empty()
                : Optional.of(new Vector(x.getAsDouble(), y.getAsDouble(), z.getAsDouble()));
    }

    Vector plus(Vector other) {
        return new Vector(x + other.x, y + other.y, z + other.z);
    }

    Vector times(double factor) {
        return new Vector(x * factor, y * factor, z * factor);
    }

    /**
     * Turns radians into degrees.
     *
     * @return each number in degrees
     */
    Vector toDegrees() {
        return new Vector(Math.toDegrees(x), Math.toDegrees(y), Math.toDegrees(z));
    }
}
