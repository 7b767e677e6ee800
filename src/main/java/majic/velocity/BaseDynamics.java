package majic.velocity;

/**
 * The limits of a base that its control uses. Immutable. All numbers are positive.
 *
 * @param slowestMmPerSec the lowest speed that the base follows: less may have no effect
 * @param slowestDegPerSec the lowest turn rate that it follows
 * @param fastestMmPerSec the highest speed that it is driven at
 * @param fastestDegPerSec the highest turn rate that it is driven at
 * @param accelerationMmPerSec2 the change of speed that it can follow, mm/s²
 * @param accelerationDegPerSec2 the change of turn rate that it can follow, deg/s²
 * @param timeoutS after this time without a velocity the base stops by itself; infinite for a base that drives on, NaN
 *     if that is not known
 * @param accuracy how exact its readings are
 */
public record BaseDynamics(
        double slowestMmPerSec,
        double slowestDegPerSec,
        double fastestMmPerSec,
        double fastestDegPerSec,
        double accelerationMmPerSec2,
        double accelerationDegPerSec2,
        double timeoutS,
        Accuracy accuracy) {
    /** The lowest speed and rate of bases of which no others are known: above the steps of a TurtleBot3 (sheet 8). */
    private static final double SLOWEST_MM_PER_SEC = 12;

    private static final double SLOWEST_DEG_PER_SEC = 3;

    /** The highest speed and rate are reached from rest within this time, seconds. */
    private static final double RAMP_S = 0.8;

    /**
     * The dynamics of a base with the accuracy of odometry.
     *
     * @param slowestMmPerSec as of the record
     * @param slowestDegPerSec as of the record
     * @param fastestMmPerSec as of the record
     * @param fastestDegPerSec as of the record
     * @param accelerationMmPerSec2 as of the record
     * @param accelerationDegPerSec2 as of the record
     * @param timeoutS as of the record
     */
    public BaseDynamics(
            double slowestMmPerSec,
            double slowestDegPerSec,
            double fastestMmPerSec,
            double fastestDegPerSec,
            double accelerationMmPerSec2,
            double accelerationDegPerSec2,
            double timeoutS) {
        this(
                slowestMmPerSec,
                slowestDegPerSec,
                fastestMmPerSec,
                fastestDegPerSec,
                accelerationMmPerSec2,
                accelerationDegPerSec2,
                timeoutS,
                Accuracy.ODOMETRY);
    }

    /** Refuses numbers that are not positive. */
    public BaseDynamics {
        boolean valid = slowestMmPerSec > 0
                && slowestDegPerSec > 0
                && fastestMmPerSec >= slowestMmPerSec
                && fastestDegPerSec >= slowestDegPerSec
                && accelerationMmPerSec2 > 0
                && accelerationDegPerSec2 > 0
                && !(timeoutS <= 0);
        if (!valid) {
            throw new IllegalArgumentException("limits have to be positive, the fastest above the slowest: "
                    + slowestMmPerSec + ", " + slowestDegPerSec + ", " + fastestMmPerSec + ", " + fastestDegPerSec
                    + ", "
                    + accelerationMmPerSec2 + ", " + accelerationDegPerSec2 + ", " + timeoutS);
        }
    }

    /**
     * The dynamics of a base of which only the highest velocities are known.
     *
     * @param fastestMmPerSec positive
     * @param fastestDegPerSec positive
     * @param timeoutS as of the record
     * @return with an acceleration that reaches these velocities within 0.8 s
     */
    public static BaseDynamics of(double fastestMmPerSec, double fastestDegPerSec, double timeoutS) {
        return new BaseDynamics(
                Math.min(SLOWEST_MM_PER_SEC, fastestMmPerSec),
                Math.min(SLOWEST_DEG_PER_SEC, fastestDegPerSec),
                fastestMmPerSec,
                fastestDegPerSec,
                fastestMmPerSec / RAMP_S,
                fastestDegPerSec / RAMP_S,
                timeoutS);
    }
}
