package majic.aibo.body;

/**
 * A point of the dog's body, or the way from one to another. Immutable.
 *
 * @param x mm ahead
 * @param y mm to its left
 * @param z mm up
 */
public record Spot(double x, double y, double z) {
    /** The point that lies by another one's coordinates further on. */
    public Spot plus(Spot way) {
        return new Spot(x + way.x, y + way.y, z + way.z);
    }

    /** Turned about an axis to the left, so that what lies ahead rises. */
    Spot raised(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Spot(x * cos - z * sin, y, x * sin + z * cos);
    }

    /** Turned about an axis upwards, so that what lies ahead goes to the left. */
    Spot panned(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Spot(x * cos - y * sin, x * sin + y * cos, z);
    }

    /** Turned about an axis ahead, so that what hangs down goes to the left. */
    public Spot spread(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Spot(x, y * cos - z * sin, y * sin + z * cos);
    }
}
