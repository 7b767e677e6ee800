package majic.ros.navigation;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.LinkLost;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** One goal of a robot, from its sending to its result. Thread-safe. */
abstract class Goal implements AutoCloseable {
    private final Signal changes;
    private final AtomicBoolean cancelled = new AtomicBoolean();
    private volatile boolean answered;
    private volatile @Nullable Result result;
    private volatile String reason = "";

    /** How a goal ended. */
    enum Result {
        SUCCEEDED,
        /** Cancelled by this program, by another one, or replaced by a newer goal. */
        CANCELLED,
        /** Given up or rejected by the robot. */
        FAILED
    }

    /**
     * A goal that is not sent yet.
     *
     * @param changes raised after each report about the goal
     */
    Goal(Signal changes) {
        this.changes = changes;
    }

    /**
     * Sends the goal; called once.
     *
     * @throws LinkLost if it could not be sent
     */
    abstract void send();

    /** Sends the request to cancel the goal; called once at most, waits for nothing. */
    abstract void sendCancel();

    /** Cancels the goal; waits for nothing, and does nothing the second time. */
    final void cancel() {
        if (!cancelled.getAndSet(true)) {
            sendCancel();
        }
    }

    /** Records that the robot pursues the goal. */
    final void reported() {
        answered = true;
        changes.raise();
    }

    /** Records the end of the goal, with the reason that the robot gave; empty for none. */
    final void end(Result how, String why) {
        reason = why;
        result = how;
        reported();
    }

    /** Returns whether the robot has reported anything about the goal. */
    final boolean isAnswered() {
        return answered;
    }

    /** Returns how it ended; empty while it is pursued. */
    final Optional<Result> result() {
        return Optional.ofNullable(result);
    }

    /** Returns what the robot gave as the reason of its end; may be empty. */
    final String reason() {
        return reason;
    }

    /** Returns how far it still is, mm; empty if the robot does not report it. */
    OptionalDouble leftMm() {
        return OptionalDouble.empty();
    }

    @Override
    public abstract void close();
}
