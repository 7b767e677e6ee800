package majic.aibo.body;

/**
 * A point of the dog's body, or the way from one to another. Immutable.
 *
 * @param x mm ahead
 * @param y mm to its left
 * @param z mm up
 */
public record BodyPoint(double x, double y, double z) {
    /** The point that lies by another one's coordinates further on. */
    public BodyPoint plus(BodyPoint way) {
        return new BodyPoint(x + way.x, y + way.y, z + way.z);
    }

    /** Turned about an axis to the left, so that what lies ahead rises. */
    BodyPoint raised(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new BodyPoint(x * cos - z * sin, y, x * sin + z * cos);
    }

    /** Turned about an axis upwards, so that what lies ahead goes to the left. */
    BodyPoint panned(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new BodyPoint(x * cos - y * sin, x * sin + y * cos, z);
    }

    /** Turned about an axis ahead, so that what hangs down goes to the left. */
    public BodyPoint spread(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new BodyPoint(x, y * cos - z * sin, y * sin + z * cos);
    }
}
