package majic.ros.readings;

import majic.ros.message.FrameTransform;
import majic.ros.message.LaserScanMessage;
import majic.ros.message.Vector;

/**
 * The echoes of one scan, in the frame of the robot: x ahead, y to the left, mm. Immutable. Beams without an echo are
 * contained, with their direction.
 */
public final class ScanPoints {
    private final double[] directionsDeg;
    private final double[] xMm;
    private final double[] yMm;
    private final LaserScanMessage scan;
    private final Vector originMm;
    private final int echoes;

    private ScanPoints(LaserScanMessage scan, FrameTransform scanner) {
        this.scan = scan;
        this.originMm = scanner.originMm();
        int beams = scan.beams();
        this.directionsDeg = new double[beams];
        this.xMm = new double[beams];
        this.yMm = new double[beams];
        int found = 0;
        for (int beam = 0; beam < beams; beam++) {
            double angle = Math.toRadians(scan.directionDeg(beam));
            Vector along = scanner.orientation().rotate(new Vector(Math.cos(angle), Math.sin(angle), 0));
            directionsDeg[beam] = Math.toDegrees(Math.atan2(along.y(), along.x()));
            double range = scan.rangeMm(beam);
            xMm[beam] = originMm.x() + range * along.x();
            yMm[beam] = originMm.y() + range * along.y();
            found += Double.isNaN(range) ? 0 : 1;
        }
        this.echoes = found;
    }

    /**
     * Converts a scan.
     *
     * @param scan as it was sent
     * @param scanner where the scanner is on the robot
     * @return its points
     */
    public static ScanPoints of(LaserScanMessage scan, FrameTransform scanner) {
        return new ScanPoints(scan, scanner);
    }

    /**
     * Returns the number of beams.
     *
     * @return with and without an echo
     */
    public int beams() {
        return xMm.length;
    }

    /**
     * Returns how many beams have an echo.
     *
     * @return 0 to {@link #beams}
     */
    public int echoes() {
        return echoes;
    }

    /**
     * Returns whether a beam has an echo.
     *
     * @param beam from 0
     * @return false if nothing is known in its direction
     */
    public boolean hasEcho(int beam) {
        return !Double.isNaN(xMm[beam]);
    }

    /**
     * Returns the direction of a beam.
     *
     * @param beam from 0
     * @return degrees in the frame of the robot, counterclockwise positive, −180 to 180
     */
    public double directionDeg(int beam) {
        return directionsDeg[beam];
    }

    /**
     * Returns where an echo is.
     *
     * @param beam with an echo
     * @return mm ahead of the turning centre
     */
    public double xMm(int beam) {
        return xMm[beam];
    }

    /**
     * Returns where an echo is.
     *
     * @param beam with an echo
     * @return mm to the left of the turning centre
     */
    public double yMm(int beam) {
        return yMm[beam];
    }

    /** The angle from one beam to the next, degrees, not negative. */
    double stepDeg() {
        return Math.abs(scan.stepDeg());
    }

    /** The least range that the scanner measures, mm. */
    double leastMm() {
        return scan.leastMm();
    }

    /** Where the scanner is on the robot, mm. */
    Vector originMm() {
        return originMm;
    }
}
