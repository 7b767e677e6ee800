package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.time.WaitPolicy;

/** Sends questions and blocks until they are answered, never longer than an answer can take. Thread-safe. */
public final class BlockingConversation {
    /** The longest wait for an answer: two tries over Bluetooth, behind another question, seconds. */
    private static final double LONGEST_S = 4;

    private final CurrentSession sessions;
    private final RobotWait waiting;
    private final BooleanSupplier connected;

    public BlockingConversation(CurrentSession sessions, RobotWait waiting, BooleanSupplier connected) {
        this.sessions = sessions;
        this.waiting = waiting;
        this.connected = connected;
    }

    /**
     * Sends a question and blocks until its answer arrives. Fails on a thread that must not block.
     *
     * @throws BotException if there is no answer; the message gives the cause
     */
    public Reply ask(Question question) {
        if (!WaitPolicy.isAllowed()) {
            throw new BotException("the robot tells it only when asked");
        }
        return awaited(sessions.conversation().ask(question));
    }

    /**
     * Sends a command, and blocks until the robot confirms it where the thread may block.
     *
     * @throws BotException if it is refused or not confirmed; the message gives the cause
     */
    public void send(Question command) {
        Exchange exchange = sessions.conversation().ask(command);
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

    /**
     * Blocks until a condition holds, but not longer than an answer can take with its repetition and others before it.
     */
    public void await(BooleanSupplier condition) {
        await(condition, LONGEST_S);
    }

    /** Blocks for a time, but ends when the connection is lost. */
    public void pause(double seconds) {
        await(() -> false, seconds);
    }

    private void await(BooleanSupplier condition, double seconds) {
        waiting.await(() -> condition.getAsBoolean() || !connected.getAsBoolean(), seconds);
    }
}
