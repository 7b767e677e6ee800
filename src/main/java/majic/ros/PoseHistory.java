package majic.ros;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import majic.bot.BotState;
import majic.bot.Pose;

/**
 * The states of a robot during the last second, to find its pose at the time of a scan. Thread-safe.
 *
 * <p>Scans arrive on another connection than the odometry, earlier or later than that of the same time.
 */
final class PoseHistory {
    private static final long KEPT_NANOS = 1_000_000_000;

    private final Deque<BotState> states = new ArrayDeque<>();

    /** Adds a state, measured no earlier than the one added before. */
    synchronized void add(BotState state) {
        states.addLast(state);
        while (states.getFirst().atNanos() < state.atNanos() - KEPT_NANOS) {
            states.removeFirst();
        }
    }

    /**
     * Returns the pose at a time: between two states by their poses, after the newest by its velocities.
     *
     * @param nanos the time
     * @param longestS how far from it the nearest state may be
     * @return empty if there is no state near to it
     */
    synchronized Optional<Pose> at(long nanos, double longestS) {
        BotState before = null;
        BotState after = null;
        for (BotState state : states) {
            if (state.atNanos() <= nanos) {
                before = state;
            } else if (after == null) {
                after = state;
            }
        }
        if (before != null && after != null) {
            return Optional.of(between(before, after, nanos));
        }
        BotState nearest = before == null ? after : before;
        if (nearest == null || Math.abs(nanos - nearest.atNanos()) / 1e9 > longestS) {
            return Optional.empty();
        }
        return Optional.of(before == null ? nearest.pose() : later(nearest, nanos));
    }

    private static Pose between(BotState before, BotState after, long nanos) {
        double part = (double) (nanos - before.atNanos()) / (after.atNanos() - before.atNanos());
        Pose from = before.pose();
        Pose to = after.pose();
        return new Pose(
                from.xMm() + part * (to.xMm() - from.xMm()),
                from.yMm() + part * (to.yMm() - from.yMm()),
                from.headingDeg() + part * Pose.normalised(to.headingDeg() - from.headingDeg()));
    }

    private static Pose later(BotState newest, long nanos) {
        double seconds = (nanos - newest.atNanos()) / 1e9;
        return newest.pose().after(newest.speedMmPerSec() * seconds, newest.turnRateDegPerSec() * seconds);
    }
}
