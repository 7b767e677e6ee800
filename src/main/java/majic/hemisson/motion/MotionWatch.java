package majic.hemisson.motion;

import majic.bot.MotionFailed;
import majic.hemisson.line.LinkQuality;
import org.jspecify.annotations.Nullable;

/** When the motion under way must be over, and what went wrong in it. Thread-safe. */
final class MotionWatch {
    /** A drive that nobody renews has lapsed before this; calls nearer to each other are one drive, ns. */
    private static final long LONGEST_DRIVE_NANOS = 700_000_000;

    /** How long after the planned end of a motion the robot is told to stand whatever the motion's thread does, ns. */
    private static final long OVERTIME_NANOS = 300_000_000;

    private static final long LINE_KEPT_FREE_NANOS = 10_000_000;

    /** A longer silence would come near to 100 ms without a question. */
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

    /** Takes note of what went wrong; what follows from it is not worth telling. */
    synchronized boolean meets(String newTrouble) {
        boolean first = trouble == null;
        if (first) {
            trouble = newTrouble;
        }
        return first;
    }

    /** Forgets earlier trouble, and sets when the motion that begins must be over at the latest. */
    synchronized void begins(long latestNanos) {
        trouble = null;
        dueNanos = latestNanos;
    }

    /** Sets when the motion under way is to end; the line is kept free for its stop shortly before. */
    void ends(long nanos) {
        dueNanos = nanos;
    }

    /**
     * Notes that somebody drives, once more or anew.
     *
     * @throws MotionFailed if this drive has met with trouble; it does not resume until it was let go
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

    /** Whether nobody has ended the motion though it was time. */
    boolean isOverdue(long nowNanos) {
        return nowNanos - dueNanos > OVERTIME_NANOS;
    }

    /** Whether a question begun now could delay the stop of a timed motion, when answers take so long as these. */
    boolean isEndNear(long nowNanos, LinkQuality quality) {
        long leftNanos = dueNanos - nowNanos;
        long answerNanos = (long) (2e6 * quality.roundTripMs());
        return leftNanos >= 0 && leftNanos < Math.min(LONGEST_KEPT_FREE_NANOS, answerNanos + LINE_KEPT_FREE_NANOS);
    }
}
