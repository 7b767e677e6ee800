package majic.hemisson;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Patience;
import majic.bot.Signal;
import org.jspecify.annotations.Nullable;

/** Makes the robot stand and waits until it has confirmed that it does. Thread-safe. */
final class Standstill {
    private static final double BESIDE_ANSWERS_S = 0.9;

    /** A robot that may set its own speeds is looked at for a while longer, seconds. */
    private static final double OWN_SPEEDS_S = 1;

    private final Sessions sessions;
    private final Signal changes;
    private final BooleanSupplier connected;
    private final Supplier<@Nullable String> contrary;

    /**
     * Does nothing yet.
     *
     * @param contrary which speeds the wheels were found at in place of those that were told
     */
    Standstill(Sessions sessions, Signal changes, BooleanSupplier connected, Supplier<@Nullable String> contrary) {
        this.sessions = sessions;
        this.changes = changes;
        this.connected = connected;
        this.contrary = contrary;
    }

    /** Has it told to stand, in the next turn on the line; does not wait. */
    void order() {
        Session open = sessions.current();
        if (open != null) {
            open.conversation().stop();
        }
    }

    /**
     * Waits for it, where the thread may wait.
     *
     * @throws BotException if it is not confirmed in time, or cannot be any more; says what a person can do
     */
    void confirm() {
        Session open = sessions.current();
        if (open == null || !Patience.isAllowed()) {
            return;
        }
        Conversation conversation = open.conversation();
        double patience = 2 * open.timeoutSeconds() + BESIDE_ANSWERS_S;
        patience += conversation.setsItsOwnSpeeds() ? OWN_SPEEDS_S : 0;
        try {
            changes.await(
                    () -> conversation.isStanding() || conversation.isContrary() || !connected.getAsBoolean(),
                    patience);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return;
        }
        if (!conversation.isStanding()) {
            throw unconfirmed(conversation.isContrary() ? contrary.get() : null, patience);
        }
    }

    private BotException unconfirmed(@Nullable String why, double patience) {
        if (!connected.getAsBoolean()) {
            return new LinkLost("the connection was lost before the stop was confirmed; " + MajicHemisson.HELP);
        }
        return new BotException(
                why == null ? "the stop was not confirmed within " + patience + " s; " + MajicHemisson.HELP : why);
    }

    /**
     * Ends the connection with a stop.
     *
     * @return what is to be said if it was not confirmed; null if all is well
     */
    @Nullable
    String end() {
        Session open = sessions.current();
        boolean stands = open == null || Farewell.say(open, changes);
        sessions.end();
        return stands ? null : "it has not confirmed that it stands; " + MajicHemisson.HELP;
    }
}
