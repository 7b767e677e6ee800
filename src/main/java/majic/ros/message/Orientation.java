package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;

/**
 * A rotation as ROS gives it, a quaternion, which need not be normalised. Immutable.
 *
 * @param x finite
 * @param y finite
 * @param z finite
 * @param w finite
 */
public record Orientation(double x, double y, double z, double w) {
    /** No rotation. */
    public static final Orientation NONE = new Orientation(0, 0, 0, 1);

    /**
     * Reads a {@code geometry_msgs/Quaternion}.
     *
     * @param message its parent
     * @param path the path to it
     * @return the rotation; none for a quaternion of zeros, which some drivers send before their first measurement
     * @throws UnusableMessage if a part is not a finite number
     */
    static Orientation from(JsonNode message, String path) {
        Orientation read = new Orientation(
                Fields.number(message, path + ".x"),
                Fields.number(message, path + ".y"),
                Fields.number(message, path + ".z"),
                Fields.number(message, path + ".w"));
        return read.square() == 0 ? NONE : read;
    }

    private double square() {
        return x * x + y * y + z * z + w * w;
    }

    /**
     * Returns the rotation around the vertical axis.
     *
     * @return degrees, counterclockwise positive, −180 to 180
     */
    public double yawDeg() {
        return Math.toDegrees(Math.atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z));
    }

    /**
     * Returns the rotation around the axis that points ahead.
     *
     * @return degrees, positive if the right side is lower, −180 to 180
     */
    public double rollDeg() {
        return Math.toDegrees(Math.atan2(2 * (w * x + y * z), w * w - x * x - y * y + z * z));
    }

    /**
     * Returns the rotation around the axis that points to the left.
     *
     * @return degrees, positive if the front is lower, −90 to 90
     */
    public double pitchDeg() {
        double sine = 2 * (w * y - z * x) / square();
        return Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, sine))));
    }

    /**
     * Rotates a vector.
     *
     * @param vector before the rotation
     * @return the vector after it, of the same length
     */
    public Vector rotate(Vector vector) {
        double scale = 2 / square();
        double tx = scale * (y * vector.z() - z * vector.y());
        double ty = scale * (z * vector.x() - x * vector.z());
        double tz = scale * (x * vector.y() - y * vector.x());
        return vector.plus(new Vector(w * tx + y * tz - z * ty, w * ty + z * tx - x * tz, w * tz + x * ty - y * tx));
    }

    /** Returns the rotation that first applies the other one, then this one. */
    Orientation times(Orientation other) {
        return new Orientation(
                w * other.x + x * other.w + y * other.z - z * other.y,
                w * other.y - x * other.z + y * other.w + z * other.x,
                w * other.z + x * other.y - y * other.x + z * other.w,
                w * other.w - x * other.x - y * other.y - z * other.z);
    }

    /** Returns the opposite rotation. */
    Orientation inverse() {
        return new Orientation(-x, -y, -z, w);
    }
}
