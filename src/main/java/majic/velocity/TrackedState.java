package majic.velocity;

import majic.bot.Pose;

/**
 * The state of a base after one reading of its odometry. Immutable.
 *
 * @param pose from where the base was connected; continuous, also where the odometry jumped
 * @param turnedDeg the heading without the step at half a turn: full turns count
 * @param speedMmPerSec ahead positive
 * @param turnRateDegPerSec counterclockwise positive
 * @param stationary whether neither the velocities nor the poses of the last moments show a motion
 * @param jumps how often the odometry has jumped so far
 * @param atNanos when the reading arrived, on the driver's clock
 */
public record TrackedState(
        Pose pose,
        double turnedDeg,
        double speedMmPerSec,
        double turnRateDegPerSec,
        boolean stationary,
        int jumps,
        long atNanos) {}
