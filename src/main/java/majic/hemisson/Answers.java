package majic.hemisson;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Signal;

/** Waits for what the robot answers, for whoever may wait; never longer than an answer can take. Thread-safe. */
final class Answers {
    /** The longest wait for an answer: two tries over Bluetooth, and somebody else's before it, seconds. */
    private static final double LONGEST_S = 4;

    private final Sessions sessions;
    private final Signal changes;
    private final BooleanSupplier connected;

    Answers(Sessions sessions, Signal changes, BooleanSupplier connected) {
        this.sessions = sessions;
        this.changes = changes;
        this.connected = connected;
    }

    /**
     * Asks one question and waits for the answer, whoever else talks.
     *
     * @throws BotException if there is none; the message says why
     */
    Reply ask(Question question) {
        Exchange exchange = sessions.conversation().ask(question);
        await(exchange::isDone);
        Reply reply = exchange.reply();
        if (reply == null) {
            String failure = exchange.failure();
            throw new BotException(failure == null ? "no answer" : failure);
        }
        return reply;
    }

    /** Waits for what an answer brings, as long as one may take with its repetition and others before it. */
    void await(BooleanSupplier condition) {
        await(condition, LONGEST_S);
    }

    /** Lets time pass, unless the connection is lost. */
    void pause(double seconds) {
        await(() -> false, seconds);
    }

    private void await(BooleanSupplier condition, double seconds) {
        try {
            changes.await(() -> condition.getAsBoolean() || !connected.getAsBoolean(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }
}
