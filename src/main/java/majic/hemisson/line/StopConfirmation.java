package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.time.Signal;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** Stops the robot and waits until it confirms that it is stopped. Thread-safe. */
public final class StopConfirmation {
    /** What a person can do about a robot that moves and cannot be reached. */
    public static final String HELP = "if it still moves, lift it, or press 5 on a TV remote control";

    private static final double BESIDE_ANSWERS_S = 0.9;

    /** Additional wait for a robot whose running mode sets speeds, seconds. */
    private static final double OWN_SPEEDS_S = 1;

    private final CurrentSession sessions;
    private final Signal changes;
    private final BooleanSupplier lost;
    private final Supplier<@Nullable String> contrary;

    /**
     * Sends nothing yet.
     *
     * @param lost whether the connection was lost; during a close the robot still answers
     * @param contrary the speeds that the robot reports instead of those sent
     */
    public StopConfirmation(
            CurrentSession sessions, Signal changes, BooleanSupplier lost, Supplier<@Nullable String> contrary) {
        this.sessions = sessions;
        this.changes = changes;
        this.lost = lost;
        this.contrary = contrary;
    }

    /** Sends a stop in the next turn of the line; does not block. */
    public void order() {
        HemissonSession open = sessions.current();
        if (open != null) {
            open.conversation().stop();
        }
    }

    /**
     * Blocks until the stop is confirmed, where the thread may block.
     *
     * @throws BotException if it is not confirmed in time, or cannot be any more; the message gives the remedy
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
     * @return a message for the user if it was not confirmed, else null
     */
    public @Nullable String end() {
        HemissonSession open = sessions.current();
        boolean stands = open == null || SessionClose.say(open, changes);
        sessions.end();
        return stands ? null : "it has not confirmed that it stands; " + HELP;
    }
}
