package majic.bot;

/**
 * The circle that a robot must not leave, about the place where it began. Immutable.
 *
 * @param xMm of its middle, in the frame of the robot's poses
 * @param yMm of its middle, in the same frame
 * @param radiusMm more than 0
 */
public record Fence(double xMm, double yMm, double radiusMm) {
    private static final double MM_PER_M = 1000;
    private static final int PER_M = 10;

    /**
     * Returns how far a place is inside.
     *
     * @param x of the place, in the frame of the robot's poses
     * @param y of the place, in the same frame
     * @return mm; negative outside
     */
    public double insideMm(double x, double y) {
        return radiusMm - Math.hypot(x - xMm, y - yMm);
    }

    /**
     * Returns how far a place is from the middle, as users read it.
     *
     * @param x of the place, in the frame of the robot's poses
     * @param y of the place, in the same frame
     * @return in m, rounded up to decimetres, so that a place outside does not look as if it were at the fence
     */
    public String distance(double x, double y) {
        return Value.plain(Math.ceil((radiusMm - insideMm(x, y)) * PER_M / MM_PER_M) / PER_M) + " m";
    }

    /** Returns the radius as users read it: {@code 10 m}. */
    public String radius() {
        return Value.plain(radiusMm / MM_PER_M) + " m";
    }
}
