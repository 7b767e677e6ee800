package majic.bot;

/**
 * One beam of a range sensor: where it is on the robot, and what it can measure. Immutable.
 *
 * @param mount place and direction in the robot's frame: x ahead of its centre of rotation, y to the left
 * @param openingDeg the full angle of the cone in which an echo may lie; 0 to 180, for a laser 1 or less
 * @param leastMm the shortest distance that it measures, 0 or more
 * @param reachMm the longest distance that it measures, more than {@code leastMm}
 * @param noiseMm the standard deviation of a measured distance, 0 or more
 */
public record Beam(Pose mount, double openingDeg, double leastMm, double reachMm, double noiseMm) {
    private static final double WIDEST_DEG = 180;

    /** Refuses what is outside the ranges above. */
    public Beam {
        if (!(openingDeg >= 0 && openingDeg <= WIDEST_DEG)) {
            throw new IllegalArgumentException("the opening of a beam is 0 to 180 deg, not " + openingDeg);
        }
        if (!(leastMm >= 0 && reachMm > leastMm && Double.isFinite(reachMm))) {
            throw new IllegalArgumentException(
                    "a beam measures from 0 mm or more to a greater distance, not " + leastMm + " to " + reachMm);
        }
        if (!(noiseMm >= 0 && Double.isFinite(noiseMm))) {
            throw new IllegalArgumentException("the noise of a beam is 0 mm or more, not " + noiseMm);
        }
    }
}
