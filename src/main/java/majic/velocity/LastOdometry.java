package majic.velocity;

import majic.bot.Pose;

/**
 * Where a base was by the last reading before the connection was lost. Immutable.
 *
 * @param pose from where the base was added
 * @param raw the same in the frame of the odometry
 * @param atNanos when the reading arrived
 */
public record LastOdometry(Pose pose, Pose raw, long atNanos) {
    /** Before the first reading of a base: it is where it is added. */
    public static final LastOdometry NONE = new LastOdometry(Pose.START, Pose.START, Long.MIN_VALUE);

    boolean exists() {
        return atNanos != Long.MIN_VALUE;
    }
}
