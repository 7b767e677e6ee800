package majic.hemisson.line;

import majic.hemisson.line.Question.Purpose;
import org.jspecify.annotations.Nullable;

/**
 * Determines which question is sent next, when and in which wording: one question at a time, a stop before all others,
 * nothing long while the robot may move. Guarded by its owner.
 */
final class SendOrder {
    /** The failure of a question that takes the line for too long while the robot moves. */
    static final String TOO_LONG = "it takes the line for too long while the robot moves, for a stop may be due";

    /** How soon a stop is sent behind a question whose answer does not come, ns. */
    private static final long STOP_WAITS_NANOS = 100_000_000;

    private final ExchangeQueue queue;
    private final OpenExchanges open;
    private final UnansweredCommands unanswered;
    private final MotionState motion;
    private final LineRecovery recovery;

    SendOrder(
            ExchangeQueue queue,
            OpenExchanges open,
            UnansweredCommands unanswered,
            MotionState motion,
            LineRecovery recovery) {
        this.queue = queue;
        this.open = open;
        this.unanswered = unanswered;
        this.motion = motion;
        this.recovery = recovery;
    }

    /** Removes the question to be sent now, which counts as sent; null if none waits or the line is not free. */
    @Nullable
    Exchange next(long nowNanos) {
        Exchange next = firstAllowed();
        if (next == null || !isFreeFor(next, nowNanos) || !unanswered.admits(wording(next), nowNanos)) {
            return null;
        }
        queue.next();
        String wording = wording(next);
        open.sent(next);
        unanswered.sent(next.question(), wording, nowNanos);
        motion.sent(next.purpose());
        next.sent(wording, nowNanos);
        return next;
    }

    private boolean isFreeFor(Exchange next, long nowNanos) {
        Exchange before = open.newest();
        return before == null ? recovery.isOver(nowNanos) : mayOvertake(next, before, nowNanos);
    }

    /** A stop waits for an answer only for a moment, where the receiver survives it. */
    private static boolean mayOvertake(Exchange next, Exchange before, long nowNanos) {
        boolean soon = before.question().isAnsweredBriefly() || nowNanos - before.sentNanos() >= STOP_WAITS_NANOS;
        return next.purpose() == Purpose.STOP && soon && before.isWritten() && !before.isOfStop();
    }

    private String wording(Exchange next) {
        return unanswered.wording(next.question(), motion.mayMove());
    }

    /** The first question that may be sent; discards those that became too long when the robot began to move. */
    private @Nullable Exchange firstAllowed() {
        Exchange first = queue.first();
        while (first != null && first.question().isLong() && motion.mayMove()) {
            queue.next();
            first.failed(TOO_LONG);
            first = queue.first();
        }
        return first;
    }
}
