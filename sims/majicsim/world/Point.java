package majicsim.world;

/**
 * A point of the room or of a robot's frame.
 *
 * @param xMm millimetres along x (in a robot's frame: ahead)
 * @param yMm millimetres along y (in a robot's frame: to the left)
 */
public record Point(double xMm, double yMm) {

    /**
     * The distance to another point.
     *
     * @param other the other point
     * @return millimetres, never negative
     */
    public double distanceTo(Point other) {
        return Math.hypot(other.xMm - xMm, other.yMm - yMm);
    }
}
