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
 * The way from a parameter to the robot: what is heard of it all the while, and questions of its own. Thread-safe.
 *
 * <p>Who must not wait, as the guard of a robot that moves, is served with what was heard last; what nobody asks all the
 * while is asked from then on in turn with the rest.
 */
public final class RobotReadings {
    /** The robot itself has new readings every 41 ms (Hemisson sheet 4.6). */
    private static final long FRESH_NANOS = 100_000_000;

    private static final long STALE_NANOS = 1_500_000_000;

    private final PolledAnswers senses;
    private final BlockingConversation answers;
    private final TimeSource time;

    public RobotReadings(PolledAnswers senses, BlockingConversation answers, TimeSource time) {
        this.senses = senses;
        this.answers = answers;
        this.time = time;
    }

    /** The robot's clock, ns. */
    public long nanos() {
        return time.nanos();
    }

    /** Reads what the proximity sensors saw last. */
    public Supplier<Value> seen(Function<Proximity, Value> reading) {
        return () -> {
            Proximity seen = senses.seen();
            return seen == null ? Value.unknown("no reading yet") : reading.apply(seen);
        };
    }

    /** Reads what is among the usual looks; asks where that is not fresh. */
    public Supplier<Value> asked(Question question, Function<Reply, Value> reading) {
        return () -> {
            Reply reply = reply(question);
            return reply == null ? Value.unknown("no reading yet") : reading.apply(reply);
        };
    }

    /** Reads what nobody but those asks for who want it. */
    public Supplier<Value> wanted(Question question, Function<Reply, Value> reading) {
        PolledQuestion look = now -> question;
        Supplier<Value> asked = asked(question, reading);
        return () -> {
            want(look);
            return asked.get();
        };
    }

    /** Has something looked at for the next seconds. */
    public void want(PolledQuestion look) {
        senses.want(look, time.nanos());
    }

    /** Lets a module do its work. */
    public void pause(double seconds) {
        answers.pause(seconds);
    }

    /** The answer to a question, fresh if there is time to wait for it; null if there is not and it was not heard. */
    @Nullable
    Reply reply(Question question) {
        boolean mayWait = WaitPolicy.isAllowed();
        Reply last = last(question, mayWait ? FRESH_NANOS : STALE_NANOS);
        return last == null && mayWait ? ask(question) : last;
    }

    /** What was heard of late. */
    public @Nullable Reply last(Question question, long ageNanos) {
        return senses.last(question, time.nanos(), ageNanos);
    }

    /** Asks something now and waits for the answer. */
    public Reply ask(Question question) {
        return answers.ask(question);
    }

    /** Tells the robot something, and waits until it has confirmed it where the thread may wait. */
    public void tell(Question order) {
        answers.tell(order);
    }

    public static Value count(int number) {
        return Value.of(number, Unit.NONE);
    }
}
