package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.time.Signal;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** Makes the robot stand and waits until it has confirmed that it does. Thread-safe. */
public final class StopConfirmation {
    /** What a person can do about a robot that moves and cannot be reached. */
    public static final String HELP = "if it still moves, lift it, or press 5 on a TV remote control";

    private static final double BESIDE_ANSWERS_S = 0.9;

    /** A robot that may set its own speeds is looked at for a while longer, seconds. */
    private static final double OWN_SPEEDS_S = 1;

    private final CurrentSession sessions;
    private final Signal changes;
    private final BooleanSupplier lost;
    private final Supplier<@Nullable String> contrary;

    /**
     * Does nothing yet.
     *
     * @param lost whether the connection was lost; while it is being closed the robot still answers
     * @param contrary which speeds the wheels were found at in place of those that were told
     */
    public StopConfirmation(
            CurrentSession sessions, Signal changes, BooleanSupplier lost, Supplier<@Nullable String> contrary) {
        this.sessions = sessions;
        this.changes = changes;
        this.lost = lost;
        this.contrary = contrary;
    }

    /** Has it told to stand, in the next turn on the line; does not wait. */
    public void order() {
        HemissonSession open = sessions.current();
        if (open != null) {
            open.conversation().stop();
        }
    }

    /**
     * Waits for it, where the thread may wait.
     *
     * @throws BotException if it is not confirmed in time, or cannot be any more; says what a person can do
     */
    public void confirm() {
        HemissonSession open = sessions.current();
        if (open == null || !WaitPolicy.isAllowed()) {
            return;
        }
        Conversation conversation = open.conversation();
        double patience = 2 * open.timeoutSeconds() + BESIDE_ANSWERS_S;
        patience += conversation.setsItsOwnSpeeds() ? OWN_SPEEDS_S : 0;
        long before = conversation.confirmations();
        BooleanSupplier stands = () -> conversation.isStanding() || conversation.confirmations() > before;
        try {
            changes.await(() -> stands.getAsBoolean() || conversation.isContrary() || isOver(open), patience);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return;
        }
        if (!stands.getAsBoolean()) {
            throw unconfirmed(open, patience);
        }
    }

    private boolean isOver(HemissonSession open) {
        return lost.getAsBoolean() || open.isClosed();
    }

    private BotException unconfirmed(HemissonSession open, double patience) {
        String why = open.conversation().isContrary() ? contrary.get() : null;
        if (isOver(open)) {
            return new LinkLost("the connection was lost before the stop was confirmed; " + HELP);
        }
        return new BotException(why == null ? "the stop was not confirmed within " + patience + " s; " + HELP : why);
    }

    /**
     * Ends the connection with a stop.
     *
     * @return what is to be said if it was not confirmed; null if all is well
     */
    public @Nullable String end() {
        HemissonSession open = sessions.current();
        boolean stands = open == null || SessionClose.say(open, changes);
        sessions.end();
        return stands ? null : "it has not confirmed that it stands; " + HELP;
    }
}
