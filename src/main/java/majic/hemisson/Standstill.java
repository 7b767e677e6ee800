package majic.hemisson;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Patience;
import majic.bot.Signal;
import org.jspecify.annotations.Nullable;

/** Makes the robot stand and waits until it has confirmed that it does. Thread-safe. */
final class Standstill {
    private static final double BESIDE_ANSWERS_S = 0.9;

    private final Sessions sessions;
    private final Signal changes;
    private final BooleanSupplier connected;

    Standstill(Sessions sessions, Signal changes, BooleanSupplier connected) {
        this.sessions = sessions;
        this.changes = changes;
        this.connected = connected;
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
        double patience = 2 * open.timeoutSeconds() + BESIDE_ANSWERS_S;
        try {
            changes.await(() -> open.conversation().isStanding() || !connected.getAsBoolean(), patience);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return;
        }
        if (!open.conversation().isStanding()) {
            throw connected.getAsBoolean()
                    ? new BotException("the stop was not confirmed within " + patience + " s; " + MajicHemisson.HELP)
                    : new LinkLost("the connection was lost before the stop was confirmed; " + MajicHemisson.HELP);
        }
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
