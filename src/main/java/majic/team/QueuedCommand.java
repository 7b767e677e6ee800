package majic.team;

import majic.bot.Permit;
import org.jspecify.annotations.Nullable;

/** An order that was accepted. Thread-safe; wait for its end at {@link Team#changes()}. */
public final class QueuedCommand {
    private final Order order;
    private final Permit permit;
    private volatile Answer.@Nullable Outcome outcome;
    private volatile boolean ended;

    QueuedCommand(Order order, Permit permit) {
        this.order = order;
        this.permit = permit;
    }

    /**
     * Returns the order.
     *
     * @return the order
     */
    public Order order() {
        return order;
    }

    /**
     * Returns how the order ended; set before any listener is called.
     *
     * @return null while it has not ended
     */
    public Answer.@Nullable Outcome outcome() {
        return outcome;
    }

    /**
     * Returns whether the order has ended, with any outcome, and its answer was given.
     *
     * @return true from then on; {@link #outcome()} returns how
     */
    public boolean hasEnded() {
        return ended;
    }

    Permit permit() {
        return permit;
    }

    void settle(Answer.Outcome how) {
        outcome = how;
    }

    void end(Answer.Outcome how) {
        outcome = how;
        ended = true;
    }
}
