package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.time.Signal;
import majic.time.WaitPolicy;

/** Waits for what the robot answers, for whoever may wait; never longer than an answer can take. Thread-safe. */
public final class BlockingConversation {
    /** The longest wait for an answer: two tries over Bluetooth, and somebody else's before it, seconds. */
    private static final double LONGEST_S = 4;

    private final CurrentSession sessions;
    private final Signal changes;
    private final BooleanSupplier connected;

    public BlockingConversation(CurrentSession sessions, Signal changes, BooleanSupplier connected) {
        this.sessions = sessions;
        this.changes = changes;
        this.connected = connected;
    }

    /**
     * Asks one question and waits for the answer. A thread that must not wait is refused.
     *
     * @throws BotException if there is none; the message says why
     */
    public Reply ask(Question question) {
        if (!WaitPolicy.isAllowed()) {
            throw new BotException("the robot tells it only when asked");
        }
        return awaited(sessions.conversation().ask(question));
    }

    /**
     * Tells the robot something, and waits until it has confirmed it where the thread may wait.
     *
     * @throws BotException if it is refused, or not confirmed; the message says why
     */
    public void tell(Question order) {
        Exchange exchange = sessions.conversation().ask(order);
        if (WaitPolicy.isAllowed() || exchange.isDone()) {
            awaited(exchange);
        }
    }

    private Reply awaited(Exchange exchange) {
        await(exchange::isDone);
        Reply reply = exchange.reply();
        if (reply == null) {
            String failure = exchange.failure();
            throw new BotException(failure == null ? "no answer" : failure);
        }
        return reply;
    }

    /** Waits for what an answer brings, as long as one may take with its repetition and others before it. */
    public void await(BooleanSupplier condition) {
        await(condition, LONGEST_S);
    }

    /** Lets time pass, unless the connection is lost. */
    public void pause(double seconds) {
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
