package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.driver.RobotWait;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/** Stops the robot and waits until it confirms that it is stopped. Thread-safe. */
public final class StopConfirmation {
    /** What the user can do about a robot that moves and cannot be reached. */
    public static final String HELP = "if it still moves, lift it, or press 5 on a TV remote control";

    /** Additional to two answers, seconds. */
    private static final double BESIDE_ANSWERS_S = 0.9;

    /** Additional wait for a robot whose running mode sets speeds, seconds. */
    private static final double OWN_SPEEDS_S = 1;

    /** The longest wait at the end of a connection, seconds; long enough for one repetition of the stop. */
    private static final double CLOSING_S = 0.8;

    private static final double TICK_S = 0.05;

    private final CurrentSession sessions;
    private final RobotWait waiting;
    private final BooleanSupplier lost;
    private final Supplier<@Nullable String> overriding;

    /**
     * Sends nothing yet.
     *
     * @param lost whether the connection was lost; during a close the robot still answers
     * @param overriding the speeds that the robot reports instead of those sent, as half a sentence
     */
    public StopConfirmation(
            CurrentSession sessions, RobotWait waiting, BooleanSupplier lost, Supplier<@Nullable String> overriding) {
        this.sessions = sessions;
        this.waiting = waiting;
        this.lost = lost;
        this.overriding = overriding;
    }

    /** Sends a stop as soon as the line allows it; does not block. */
    public void send() {
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
        double seconds = 2 * open.timeoutSeconds() + BESIDE_ANSWERS_S;
        seconds += conversation.hasOwnSpeeds() ? OWN_SPEEDS_S : 0;
        long before = conversation.confirmations();
        BooleanSupplier stopped = () -> conversation.isStopped() || conversation.confirmations() > before;
        waiting.awaitClosing(() -> stopped.getAsBoolean() || conversation.isOverridden() || isOver(open), seconds);
        if (!stopped.getAsBoolean() && !Thread.currentThread().isInterrupted()) {
            throw unconfirmed(open, seconds);
        }
    }

    private boolean isOver(HemissonSession open) {
        return lost.getAsBoolean() || open.isClosed();
    }

    private BotException unconfirmed(HemissonSession open, double seconds) {
        String why = open.conversation().isOverridden() ? overriding.get() : null;
        if (isOver(open)) {
            return new LinkLost("the connection was lost before the stop was confirmed; " + HELP);
        }
        return new BotException(why == null ? "the stop was not confirmed within " + seconds + " s; " + HELP : why);
    }

    /**
     * Ends the connection with a stop (Hemisson sheet 11), unless the last one is certainly in effect. Blocks for
     * {@value #CLOSING_S} s at most. Nothing may be sent any more that moves the robot.
     *
     * @return a message for the user if the stop was not confirmed, else null
     */
    public @Nullable String end() {
        HemissonSession open = sessions.current();
        boolean stopped = open == null || open.conversation().isCertainlyStopped() || stop(open);
        sessions.end();
        return stopped ? null : "it has not confirmed its stop; " + HELP;
    }

    /**
     * Stops the robot and waits for the confirmation. Checks for overdue answers on the calling thread, because the
     * robot's timer thread may have ended. A further stop by another thread does not undo a confirmation.
     */
    private boolean stop(HemissonSession open) {
        Conversation conversation = open.conversation();
        long before = conversation.confirmations();
        BooleanSupplier over = () -> open.isClosed() || conversation.confirmations() > before;
        conversation.stop();
        double waited = 0;
        while (waited < CLOSING_S
                && !over.getAsBoolean()
                && !Thread.currentThread().isInterrupted()) {
            waiting.awaitClosing(over, TICK_S);
            conversation.tick();
            waited += TICK_S;
        }
        return conversation.confirmations() > before || conversation.isStopped();
    }
}
