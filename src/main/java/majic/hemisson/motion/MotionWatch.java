package majic.hemisson.motion;

import majic.bot.MotionFailed;
import majic.hemisson.line.LinkQuality;
import org.jspecify.annotations.Nullable;

/** The deadline of the motion under way, and what went wrong in it. Thread-safe. */
final class MotionWatch {
    /** A drive that is not renewed has expired before this; calls within this time are one drive, ns. */
    private static final long LONGEST_DRIVE_NANOS = 700_000_000;

    /** How long after its planned end a motion is stopped even if its own thread does nothing, ns. */
    private static final long OVERTIME_NANOS = 300_000_000;

    private static final long LINE_KEPT_FREE_NANOS = 10_000_000;

    /** With a longer pause, questions would come more than 100 ms apart. */
    private static final long LONGEST_KEPT_FREE_NANOS = 40_000_000;

    private volatile long dueNanos = Long.MAX_VALUE;
    private volatile long drivenNanos;
    private volatile @Nullable String trouble;

    MotionWatch(long nowNanos) {
        drivenNanos = nowNanos - LONGEST_DRIVE_NANOS;
    }

    /** What went wrong since the last motion began, as half a sentence; null if nothing did. */
    @Nullable
    String trouble() {
        return trouble;
    }

    /**
     * Records what went wrong, unless something is recorded already.
     *
     * @return whether it is the first since the motion began
     */
    synchronized boolean meets(String newTrouble) {
        boolean first = trouble == null;
        if (first) {
            trouble = newTrouble;
        }
        return first;
    }

    /** Clears earlier trouble, and sets the deadline of the motion that begins. */
    synchronized void begins(long latestNanos) {
        trouble = null;
        dueNanos = latestNanos;
    }

    /** Sets when the motion under way is to end; the line is kept free for its stop shortly before. */
    void ends(long nanos) {
        dueNanos = nanos;
    }

    /**
     * Records that a drive begins or is renewed.
     *
     * @throws MotionFailed if something went wrong in this drive; a new one may begin after it has expired
     */
    synchronized void drives(long nowNanos) {
        String met = trouble;
        boolean goesOn = nowNanos - drivenNanos < LONGEST_DRIVE_NANOS;
        drivenNanos = nowNanos;
        if (goesOn && met != null) {
            throw new MotionFailed(met);
        }
        begins(nowNanos + LONGEST_DRIVE_NANOS);
    }

    /** Whether the motion has not been ended though it is past its deadline. */
    boolean isOverdue(long nowNanos) {
        return nowNanos - dueNanos > OVERTIME_NANOS;
    }

    /**
     * Whether a question sent now could delay the stop of a timed motion.
     *
     * @param quality gives how long answers take
     */
    boolean isEndNear(long nowNanos, LinkQuality quality) {
        long leftNanos = dueNanos - nowNanos;
        long answerNanos = (long) (2e6 * quality.roundTripMs());
        return leftNanos >= 0 && leftNanos < Math.min(LONGEST_KEPT_FREE_NANOS, answerNanos + LINE_KEPT_FREE_NANOS);
    }
}
