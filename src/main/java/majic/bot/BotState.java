package majic.bot;

import majic.time.TimeSource;

/**
 * The newest state that a robot reported, as far as all robots report it. Immutable.
 *
 * @param pose where it is, from where it was added
 * @param speedMmPerSec ahead positive
 * @param turnRateDegPerSec counterclockwise positive
 * @param moving whether it moves or has been commanded to
 * @param atNanos when the robot reported it, on its {@link TimeSource}
 */
public record BotState(Pose pose, double speedMmPerSec, double turnRateDegPerSec, boolean moving, long atNanos) {
    /** The state before the first report of a robot. */
    public static final BotState UNKNOWN = new BotState(Pose.START, 0, 0, false, 0);
}
