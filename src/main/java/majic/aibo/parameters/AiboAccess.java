package majic.aibo.parameters;

import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import majic.aibo.body.Senses;
import majic.aibo.body.Sensor;
import majic.aibo.session.AiboSession;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.WaitPolicy;

/** Gives parameters access to the dog: reported values, questions, and commands whose end is awaited. Thread-safe. */
public final class AiboAccess {
    /** A slow engine takes two seconds to answer. */
    private static final double ANSWER_S = 4;

    private static final Value NOT_REPORTED = Value.unknown("the dog tells it only when asked");

    private final Tags tags = new Tags();
    private final Senses senses;
    private final Supplier<AiboSession> session;

    public AiboAccess(Senses senses, Supplier<AiboSession> session) {
        this.senses = senses;
        this.session = session;
    }

    Senses senses() {
        return senses;
    }

    /**
     * The session there is.
     *
     * @throws LinkLost if there is none
     */
    AiboSession open() {
        return session.get();
    }

    /** Reads what the dog reports anyway. */
    Supplier<Value> sensed(Sensor sensor, Unit unit) {
        return () -> senses.value(sensor, 1, unit);
    }

    /** Asks the dog each time. */
    Supplier<Value> asked(String expression, DoubleFunction<Value> reading) {
        return () -> ask(List.of(expression), reading).get(0);
    }

    /** Asks for several things at once: the questions go out one behind the other, then all answers are awaited. */
    Supplier<Value> askedAll(List<String> expressions, Unit unit) {
        return () -> Value.many(ask(expressions, amount -> Value.of(amount, unit)));
    }

    /** What the dog answers to each, in order; unknown with the reason where it gives no number. */
    List<Value> ask(List<String> expressions, DoubleFunction<Value> reading) {
        AiboSession open = session.get();
        if (!WaitPolicy.isAllowed()) {
            return Collections.nCopies(expressions.size(), NOT_REPORTED);
        }
        UrbiConnection on = open.connections().sensors();
        List<UrbiRequest> asks =
                expressions.stream().map(expression -> on.ask(tags, expression)).toList();
        open.waiting().await(() -> on.isEnded() || asks.stream().allMatch(UrbiRequest::isDone), ANSWER_S);
        asks.forEach(on::forget);
        return asks.stream().map(ask -> value(ask, reading)).toList();
    }

    private static Value value(UrbiRequest ask, DoubleFunction<Value> reading) {
        if (ask.value() instanceof UrbiValue.Num number && Double.isFinite(number.amount())) {
            return reading.apply(number.amount());
        }
        String failure = ask.failure();
        return Value.unknown(failure == null ? "the dog does not answer" : "the dog says: " + failure);
    }

    /**
     * Has the dog do something that moves nothing, and waits until it has, where the thread may wait.
     *
     * @throws BotException if the dog refuses or does not report the end in time
     */
    void tell(List<String> commands) {
        AiboSession open = session.get();
        UrbiConnection on = open.connections().sensors();
        UrbiRequest ask = new UrbiRequest(tags.next(), UrbiRequest.Expects.END);
        on.send(ask, ask.tag() + "+end: " + UrbiCommands.together(commands) + ";");
        if (!WaitPolicy.isAllowed()) {
            return;
        }
        open.waiting().await(() -> on.isEnded() || ask.isDone(), ANSWER_S);
        on.forget(ask);
        String failure = ask.failure();
        if (failure != null) {
            throw new UrbiRefusal("the dog refuses: " + failure);
        }
        if (!ask.isDone()) {
            throw new UrbiRefusal("the dog did not do it within " + Value.plain(ANSWER_S) + " s");
        }
    }
}
