package majic.team;

import majic.bot.Permit;
import org.jspecify.annotations.Nullable;

/** An order that was accepted. Thread-safe; who waits for it, waits at {@link Team#changes()}. */
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
     * What was ordered.
     *
     * @return the order
     */
    public Order order() {
        return order;
    }

    /**
     * How it ended, from before anybody is told.
     *
     * @return null while it has not
     */
    public Answer.@Nullable Outcome outcome() {
        return outcome;
    }

    /**
     * Whether it has ended, well or not, and its answer was given.
     *
     * @return true from then on; {@link #outcome()} tells how
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
