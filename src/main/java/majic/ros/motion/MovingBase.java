package majic.ros.motion;

import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** The newest state of a base, waiting for later ones, and the sender of its velocities. Thread-safe. */
final class MovingBase {
    /** A reading shows the effect of a stop after this time at the earliest, seconds. */
    private static final double LEAST_DELAY_S = 0.05;

    /** The odometry is silent if nothing usable has come for so long, seconds. */
    private static final double SILENCE_S = 1;

    private final RobotWait waiting;
    private final VelocitySender sender;
    private final OdometryDelay delay = new OdometryDelay();
    private volatile @Nullable TrackedState now;
    private volatile @Nullable Unusable unusable;
    private volatile boolean ended;

    private record Unusable(String reason, long atNanos) {}

    MovingBase(RobotWait waiting, VelocitySender sender) {
        this.waiting = waiting;
        this.sender = sender;
    }

    TimeSource time() {
        return waiting.time();
    }

    VelocitySender sender() {
        return sender;
    }

    OdometryDelay delay() {
        return delay;
    }

    void set(TrackedState newest) {
        now = newest;
        waiting.changes().raise();
    }

    /** Wakes waiting threads for good: no reading will come any more. */
    void end() {
        ended = true;
        waiting.changes().raise();
    }

    void unusable(String reason) {
        unusable = new Unusable(reason, time().nanos());
    }

    /** Returns, as half a sentence, that there has been no usable odometry for a second; null if there has. */
    @Nullable
    String silence() {
        TrackedState newest = now;
        Unusable last = unusable;
        if (newest != null && time().secondsSince(newest.atNanos()) <= SILENCE_S) {
            return null;
        }
        boolean unreadable = last != null && time().secondsSince(last.atNanos()) <= SILENCE_S;
        return unreadable
                ? "its odometry is unusable: " + last.reason()
                : "its odometry has been silent for " + Value.plain(SILENCE_S) + " s";
    }

    boolean hasEnded() {
        return ended;
    }

    boolean isKnown() {
        return now != null;
    }

    /**
     * The newest state.
     *
     * @throws MotionFailed before the first reading
     */
    TrackedState now() {
        TrackedState newest = now;
        if (newest == null) {
            throw new MotionFailed("there has been no odometry yet, so it cannot be moved");
        }
        return newest;
    }

    /** Whether a reading shows the base stationary that was made after a zero velocity took effect. */
    boolean isStationarySince(long zeroNanos) {
        TrackedState newest = now;
        double waitS = Math.max(LEAST_DELAY_S, delay.seconds());
        return newest != null && newest.stationary() && (newest.atNanos() - zeroNanos) / 1e9 >= waitS;
    }

    /**
     * Waits until the base is stationary after the stop that was sent last, or another velocity is in force.
     *
     * @param seconds the longest wait; none on a thread that must not wait
     * @return whether it is
     * @throws LinkLost if the connection ended before
     */
    boolean awaitStationary(double seconds) {
        boolean over = waiting.await(() -> ended || isOver(), WaitPolicy.isAllowed() ? seconds : 0);
        if (ended && !isOver()) {
            throw new LinkLost("connection lost before the odometry showed the base stationary");
        }
        return over;
    }

    private boolean isOver() {
        return sender.isMoving() || isStationarySince(sender.stopNanos());
    }
}
