package majic.aibo.parameters;

import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
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
import majic.driver.RobotWait;
import majic.time.WaitPolicy;

/** Reads values of parameters from the dog and sends settings to it. Thread-safe. */
public final class AiboAccess {
    /** A slow engine takes two seconds to answer. */
    private static final double ANSWER_S = 4;

    private static final Value NOT_REPORTED = Value.unknown("the dog tells it only when asked");

    private final Tags tags = new Tags();
    private final SensorReadings senses;
    private final RobotWait waiting;
    private final Supplier<AiboSession> session;

    public AiboAccess(SensorReadings senses, RobotWait waiting, Supplier<AiboSession> session) {
        this.senses = senses;
        this.waiting = waiting;
        this.session = session;
    }

    SensorReadings senses() {
        return senses;
    }

    /**
     * The open session.
     *
     * @throws LinkLost if there is none
     */
    AiboSession open() {
        return session.get();
    }

    /** Reads a value that the dog reports periodically. */
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

    /** The answers in order; unknown with the reason where the dog gives no number. */
    List<Value> ask(List<String> expressions, DoubleFunction<Value> reading) {
        UrbiConnection on = session.get().connections().sensors();
        if (!WaitPolicy.isAllowed()) {
            return Collections.nCopies(expressions.size(), NOT_REPORTED);
        }
        List<UrbiRequest> asks =
                expressions.stream().map(expression -> on.ask(tags, expression)).toList();
        waiting.await(() -> on.isEnded() || asks.stream().allMatch(UrbiRequest::isDone), ANSWER_S);
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
     * Sends commands that move nothing, and blocks until the dog has ended them, where the thread may block.
     *
     * @throws BotException if the dog refuses or does not report the end in time
     */
    void send(List<String> commands) {
        UrbiConnection on = session.get().connections().sensors();
        UrbiRequest ask = new UrbiRequest(tags.next(), UrbiRequest.Expects.END);
        on.send(ask, ask.tag() + "+end: " + UrbiCommands.together(commands) + ";");
        if (!WaitPolicy.isAllowed()) {
            return;
        }
        waiting.await(() -> on.isEnded() || ask.isDone(), ANSWER_S);
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
