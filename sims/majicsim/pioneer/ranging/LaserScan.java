package majicsim.pioneer.ranging;

/**
 * Which directions the simulated laser measures, as SIM_LRF_SET_FOV_START, _END and _SET_RES set them (ARCOS sheet
 * 6.2). Degrees are counterclockwise from straight ahead; the first reading looks at the start. Immutable.
 *
 * @param startDeg -180 to 180
 * @param endDeg -180 to 180
 * @param stepDeg between two readings, {@value #FINEST_DEG} or more
 */
public record LaserScan(double startDeg, double endDeg, double stepDeg) {
    /** A scanner of the vendor's robots by default: half a circle ahead, one reading a degree. */
    public static final LaserScan USUAL = new LaserScan(-90, 90, 1);

    static final double FINEST_DEG = 0.1;

    private static final double MOST_DEG = 180;

    /** Limits the values to what the scanner can do. */
    public LaserScan {
        startDeg = Math.max(-MOST_DEG, Math.min(MOST_DEG, startDeg));
        endDeg = Math.max(-MOST_DEG, Math.min(MOST_DEG, endDeg));
        stepDeg = Math.max(FINEST_DEG, stepDeg);
    }

    public LaserScan from(double newStartDeg) {
        return new LaserScan(newStartDeg, endDeg, stepDeg);
    }

    public LaserScan to(double newEndDeg) {
        return new LaserScan(startDeg, newEndDeg, stepDeg);
    }

    public LaserScan every(double newStepDeg) {
        return new LaserScan(startDeg, endDeg, newStepDeg);
    }

    /** How many readings it has; one at least. */
    int readings() {
        return 1 + (int) Math.floor(Math.abs(endDeg - startDeg) / stepDeg + 1e-9);
    }

    /** Where reading {@code index} looks. */
    double directionDeg(int index) {
        return Math.min(startDeg, endDeg) + index * stepDeg;
    }
}
