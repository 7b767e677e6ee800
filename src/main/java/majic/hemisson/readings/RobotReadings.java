package majic.hemisson.readings;

import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.Unit;
import majic.bot.Value;
import majic.hemisson.line.BlockingConversation;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Reads values for parameters: from the polled answers if they are recent, else by a question of its own. Thread-safe.
 *
 * <p>A thread that must not block, such as one that checks a guard condition, gets the last polled value. A value
 * outside the regular polls is polled for some seconds after each read.
 */
public final class RobotReadings {
    /** The robot itself has new readings every 41 ms (Hemisson sheet 4.6). */
    private static final long FRESH_NANOS = 100_000_000;

    private static final long STALE_NANOS = 1_500_000_000;

    private final PolledAnswers polled;
    private final BlockingConversation answers;
    private final TimeSource time;

    public RobotReadings(PolledAnswers polled, BlockingConversation answers, TimeSource time) {
        this.polled = polled;
        this.answers = answers;
        this.time = time;
    }

    /** The robot's clock, ns. */
    public long nanos() {
        return time.nanos();
    }

    /** Reads from the latest proximity readings. */
    public Supplier<Value> proximity(Function<Proximity, Value> reading) {
        return () -> {
            Proximity latest = polled.proximity();
            return latest == null ? Value.unknown("no reading yet") : reading.apply(latest);
        };
    }

    /** Reads the answer to a question of the regular polls; asks if there is no recent one. */
    public Supplier<Value> asked(Question question, Function<Reply, Value> reading) {
        return () -> {
            Reply reply = reply(question);
            return reply == null ? Value.unknown("no reading yet") : reading.apply(reply);
        };
    }

    /** Reads the answer to a question that is polled only while something reads it. */
    public Supplier<Value> polledWhileRead(Question question, Function<Reply, Value> reading) {
        PolledQuestion poll = now -> question;
        Supplier<Value> asked = asked(question, reading);
        return () -> {
            request(poll);
            return asked.get();
        };
    }

    /** Polls a question for the next seconds. */
    public void request(PolledQuestion question) {
        polled.request(question);
    }

    /** Blocks while a module works. */
    public void pause(double seconds) {
        answers.pause(seconds);
    }

    /**
     * The answer to a question: recent if the thread may block for it; else the last polled one, null if there is none.
     */
    @Nullable
    Reply reply(Question question) {
        boolean mayWait = WaitPolicy.isAllowed();
        Reply last = last(question, mayWait ? FRESH_NANOS : STALE_NANOS);
        return last == null && mayWait ? ask(question) : last;
    }

    /** The last polled answer to a question; null if there is none of this age. */
    public @Nullable Reply last(Question question, long ageNanos) {
        return polled.last(question, ageNanos);
    }

    /** Asks a question and blocks until the answer arrives. */
    public Reply ask(Question question) {
        return answers.ask(question);
    }

    /** Sends a command, and blocks until the robot confirms it where the thread may block. */
    public void send(Question command) {
        answers.send(command);
    }

    public static Value count(int number) {
        return Value.of(number, Unit.NONE);
    }
}
