package majic.velocity;

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

    /** An older reading counts as none, seconds: the base has moved on. */
    private static final double OLD_S = 1.5;

    /** What a base has covered when the odometry shows the effect of a velocity. */
    private static final double SHOWN_MM = 1;

    private static final double SHOWN_DEG = 0.2;

    private final RobotWait waiting;
    private final VelocitySender sender;
    private final OdometryDelay delay;
    private final Accuracy accuracy;
    private volatile @Nullable TrackedState now;
    private volatile long measuredNanos;
    private volatile @Nullable Unusable unusable;
    private volatile @Nullable Begun begun;
    private volatile boolean ended;

    /** The first velocity after a standstill: when it was sent, and the newest state at that time. */
    private record Begun(TrackedState from, long atNanos) {
        /** Whether a state shows its effect, or would show it by now if it had one. */
        boolean isShownBy(TrackedState later, double longestS) {
            return from.pose().distanceMm(later.pose()) >= SHOWN_MM
                    || Math.abs(later.turnedDeg() - from.turnedDeg()) >= SHOWN_DEG
                    || (later.atNanos() - atNanos) / 1e9 >= longestS;
        }
    }

    private record Unusable(String reason, long atNanos) {}

    MovingBase(RobotWait waiting, VelocitySender sender, OdometryDelay delay, Accuracy accuracy) {
        this.waiting = waiting;
        this.sender = sender;
        this.delay = delay;
        this.accuracy = accuracy;
    }

    Accuracy accuracy() {
        return accuracy;
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

    /** Takes the newest state, and when it was measured. */
    void set(TrackedState newest, long newestMeasuredNanos) {
        measuredNanos = newestMeasuredNanos;
        now = newest;
        waiting.changes().raise();
    }

    /** Takes the first velocity after a standstill, before it is sent. */
    void begin() {
        TrackedState newest = now;
        if (newest != null) {
            begun = new Begun(newest, time().nanos());
        }
    }

    /** Wakes waiting threads for good: no reading will come any more. */
    void end() {
        ended = true;
        waiting.changes().raise();
    }

    void unusable(String reason) {
        unusable = new Unusable(reason, time().nanos());
    }

    /** Returns, as half a sentence, that there has been no usable odometry of late; null if there has. */
    @Nullable
    String silence() {
        TrackedState newest = now;
        Unusable last = unusable;
        if (newest != null && time().secondsSince(newest.atNanos()) <= SILENCE_S) {
            double oldS = time().secondsSince(measuredNanos);
            return oldS <= OLD_S ? null : "its odometry arrives " + Value.plain(oldS) + " s late";
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

    /**
     * Whether a reading shows the base stationary that was made after a zero velocity took effect. As long as the
     * odometry has not shown the motion before it either, a stationary base is one that is about to move.
     */
    boolean isStationarySince(long zeroNanos) {
        TrackedState newest = now;
        Begun last = begun;
        double waitS = Math.max(LEAST_DELAY_S, delay.seconds());
        return newest != null
                && newest.stationary()
                && (newest.atNanos() - zeroNanos) / 1e9 >= waitS
                && (last == null || last.isShownBy(newest, delay.longestSeconds()));
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
