package majic.velocity;

/**
 * How exact the readings of a base are, and so how exactly its motions end. Immutable. All numbers are positive unless
 * stated otherwise.
 *
 * @param reachedMm the distance from the target that counts as reached on the way there, mm
 * @param reachedDeg the angle from the target that counts as reached, degrees
 * @param acceptableMm what remains of a distance without being corrected
 * @param acceptableDeg what remains of an angle without being corrected
 * @param tolerableMm what may remain at most; otherwise the motion has failed
 * @param tolerableDeg the same of an angle
 * @param stationaryMmPerSec a stationary base is slower than this by the velocities that it reports
 * @param stationaryDegPerSec the same of the turn rate
 * @param restS a base counts as stationary when it has been slower than that for this time, seconds; 0 or more
 * @param driftMmPerSec the poses of a stationary base move more slowly than this
 * @param windowS poses are compared over this time, seconds: the noise of two poses in a row would look like a motion
 * @param progressMm a base that moves covers this within 2 s
 * @param progressDeg the same of an angle
 */
public record Accuracy(
        double reachedMm,
        double reachedDeg,
        double acceptableMm,
        double acceptableDeg,
        double tolerableMm,
        double tolerableDeg,
        double stationaryMmPerSec,
        double stationaryDegPerSec,
        double restS,
        double driftMmPerSec,
        double windowS,
        double progressMm,
        double progressDeg) {
    /** Of a base that counts the turns of its wheels. */
    public static final Accuracy ODOMETRY = new Accuracy(1, 0.15, 5, 0.5, 10, 1, 8, 1.5, 0, 8, 0.2, 5, 1);

    /**
     * Of a base that finds its position by satellites: a stationary one wanders by 20 mm/s (MAVLink sheet 11, and
     * recorded), by more from one fix to the next.
     */
    public static final Accuracy SATELLITES = new Accuracy(20, 0.5, 60, 1.5, 200, 4, 60, 3, 0.5, 200, 1, 50, 3);
}
