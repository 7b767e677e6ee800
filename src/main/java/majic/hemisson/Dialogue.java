package majic.hemisson;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.TimeSource;
import majic.hemisson.Question.Purpose;
import org.jspecify.annotations.Nullable;

/**
 * Who may speak next, and what the answers mean: one question at a time, a stop before all others and again until it is
 * believed, nothing long while the robot may move. Sends nothing itself. Guarded by its owner.
 */
final class Dialogue {
    private static final Logger LOG = System.getLogger(Dialogue.class.getName());

    private static final int MOST_SENDINGS = 2;
    private static final String TOO_LONG =
            "it takes the line for too long while the robot moves, for a stop may be due";
    private static final String DEAFENING =
            "its switches select no running mode, and a command so long could deafen it; put all four to the side that "
                    + "reads 1 and switch it off and on";

    private final TimeSource time;
    private final long timeoutNanos;
    private final ExchangeQueue queue = new ExchangeQueue();
    private final LinkQuality.Meter meter = new LinkQuality.Meter();
    private final Stillness stillness = new Stillness();
    private final Settling settling;
    private @Nullable Exchange inFlight;
    private @Nullable String ended;
    private long answeredNanos;

    Dialogue(TimeSource time, double timeoutSeconds) {
        this.time = time;
        this.timeoutNanos = (long) (timeoutSeconds * 1e9);
        this.answeredNanos = time.nanos();
        this.settling = new Settling(answeredNanos);
    }

    Stillness stillness() {
        return stillness;
    }

    Settling settling() {
        return settling;
    }

    LinkQuality quality() {
        return meter.read();
    }

    /** Whether it was told to stand, confirmed that, and has been told nothing else since. */
    boolean isStanding() {
        return !stillness.mayMove() && !isStopping();
    }

    long silentNanos() {
        return time.nanos() - answeredNanos;
    }

    /** Takes a question into the queue, or refuses it at once. */
    Exchange ask(Question question) {
        Exchange exchange = new Exchange(question);
        String refusal = refusal(question);
        if (refusal != null) {
            exchange.failed(refusal);
            return exchange;
        }
        if (question.purpose() == Purpose.MOTION) {
            queue.discard(Purpose.MOTION, "replaced");
        }
        queue.add(exchange);
        return exchange;
    }

    private @Nullable String refusal(Question question) {
        if (ended != null) {
            return ended;
        }
        if (question.purpose() == Purpose.MOTION && stillness.isDoubtful() && isStopping()) {
            return "it has not yet confirmed the stop";
        }
        if (stillness.isBrief() && !question.isBrief()) {
            return DEAFENING;
        }
        return question.isLong() && stillness.mayMove() ? TOO_LONG : null;
    }

    void stop() {
        Exchange open = inFlight;
        if (open != null && open.purpose() == Purpose.STOP) {
            queue.discard(Purpose.MOTION, "stopped");
        } else {
            queue.stop(stillness.isBrief() ? Question.VERIFY : Question.STOP);
        }
    }

    void end(String why) {
        ended = why;
        if (inFlight != null) {
            inFlight.failed(why);
        }
        queue.discardAll(why);
    }

    /** What is to be sent now; null if nothing waits or the line is not free. Whoever gets it sends it. */
    @Nullable
    Exchange next() {
        if (inFlight != null || !settling.isOver(time.nanos())) {
            return null;
        }
        Exchange next = nextFitting();
        if (next != null) {
            inFlight = next;
            if (next.sendings() > 0) {
                meter.repeated();
            }
            stillness.sent(next.purpose());
            next.sent(time.nanos());
        }
        return next;
    }

    /** What has been waiting since before the robot began to move may be too long by now. */
    private @Nullable Exchange nextFitting() {
        Exchange next = queue.next();
        while (next != null && next.question().isLong() && stillness.mayMove()) {
            next.failed(TOO_LONG);
            next = queue.next();
        }
        return next;
    }

    Outcome received(Reply reply) {
        return switch (reply.kind()) {
            case GREETING -> gotGreeting();
            case REFUSED -> gotRefusal(reply);
            case ANSWER, OTHER -> gotAnswer(reply);
        };
    }

    /** Gives up a question that has waited too long for its answer. */
    Outcome overdue() {
        Exchange open = inFlight;
        if (open == null || !open.isWritten() || time.nanos() - open.sentNanos() < timeoutNanos) {
            return Outcome.NONE;
        }
        meter.missed(time.nanos());
        LOG.log(Level.DEBUG, "no answer to {0}", open.question().text());
        return giveUp(open, "no answer within " + timeoutNanos / 1_000_000 + " ms");
    }

    private Outcome gotAnswer(Reply reply) {
        Exchange open = inFlight;
        if (open == null || !open.question().isAnsweredBy(reply)) {
            LOG.log(Level.DEBUG, "dropped, answers nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        close(open, reply);
        meter.answered(open.roundTripNanos());
        switch (stillness.answered(open.purpose(), reply)) {
            case VERIFY -> queue.addFirst(new Exchange(Question.VERIFY));
            case STOP -> stop();
            case STOP_LATER -> stopAfterAPause();
            case NOTHING -> LOG.log(Level.TRACE, "nothing follows");
        }
        return Outcome.answered(open);
    }

    private void close(Exchange open, Reply reply) {
        inFlight = null;
        answeredNanos = time.nanos();
        open.answered(reply, answeredNanos);
    }

    private void stopAfterAPause() {
        settling.begin(time.nanos());
        stop();
    }

    private Outcome gotRefusal(Reply reply) {
        Exchange open = inFlight;
        if (open == null) {
            LOG.log(Level.DEBUG, "dropped, refuses nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        if (open.purpose() != Purpose.VERIFY && open.question() != Question.NOTHING) {
            answeredNanos = time.nanos();
            open.refused();
            return giveUp(open, "the robot refused " + open.question().text() + ": " + reply.text());
        }
        close(open, reply);
        if (open.purpose() == Purpose.VERIFY) {
            stillness.cannotTell();
        }
        return Outcome.answered(open);
    }

    /** The robot was switched on or reset: its motors stand, and what was asked before is forgotten (sheet 11). */
    private Outcome gotGreeting() {
        if (inFlight != null) {
            inFlight.failed(Exchange.RESET);
            inFlight = null;
        }
        queue.discardAll(Exchange.RESET);
        stillness.wasReset();
        stopAfterAPause();
        return Outcome.RESET;
    }

    /** Decides what becomes of a question without answer. Nothing that moves survives it: nothing resumes by itself. */
    private Outcome giveUp(Exchange open, String why) {
        inFlight = null;
        settling.begin(time.nanos());
        stillness.missed();
        queue.discard(Purpose.MOTION, why);
        if (mayRepeat(open)) {
            queue.repeat(open);
        } else {
            open.failed(why);
        }
        boolean inMotion = stillness.mayMove();
        if (inMotion || open.isOfStop()) {
            stop();
        }
        return Outcome.missed(open, inMotion);
    }

    private boolean mayRepeat(Exchange open) {
        boolean once = open.purpose() == Purpose.ASK && open.sendings() < MOST_SENDINGS;
        return once && !stillness.mayMove() && open.question() != Question.NOTHING;
    }

    private boolean isStopping() {
        Exchange open = inFlight;
        return (open != null && open.isOfStop()) || queue.holds(Purpose.STOP) || queue.holds(Purpose.VERIFY);
    }
}
