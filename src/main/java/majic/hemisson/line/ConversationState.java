package majic.hemisson.line;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.hemisson.line.Question.Purpose;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Decides what is sent next, and what the answers mean: one question at a time, a stop before all others and again until
 * it is confirmed, nothing long while the robot may move. Sends nothing itself. Guarded by its owner.
 *
 * <p>A line that stalls may deliver a question and the stop behind it together, and the stop would deafen a robot that
 * answers the question. So a question to a moving robot carries the arguments of a stop, "N,0,0", which the robot ignores
 * and keeps; behind it "D" alone is a stop, and its two characters find room in the receiver. Nothing follows those two
 * until something is answered or the line counts as empty.
 */
final class ConversationState {
    private static final Logger LOG = System.getLogger(ConversationState.class.getName());

    private static final int MOST_SENDINGS = 2;

    /** How soon a stop goes out behind a question whose answer does not come, ns. */
    private static final long STOP_WAITS_NANOS = 100_000_000;

    /** How soon a stop is sent again, ns. */
    private static final long STOP_AGAIN_NANOS = 300_000_000;

    private static final String OVERTAKEN = "no answer before the stop";
    private static final String TOO_LONG =
            "it takes the line for too long while the robot moves, for a stop may be due";
    private static final String DEAFENING =
            "its switches select no running mode, and a command so long could deafen it; put all four to the side that "
                    + "reads 1 and switch it off and on";

    private final TimeSource time;
    private final long timeoutNanos;
    private final UnansweredCommands unanswered;
    private final ExchangeQueue queue = new ExchangeQueue();
    private final LinkQuality.Meter meter = new LinkQuality.Meter();
    private final MotionState stillness = new MotionState();
    private final LineRecovery settling;
    private @Nullable Exchange inFlight;
    private @Nullable Exchange overtaken;
    private @Nullable String ended;
    private boolean endedInStop;
    private long answeredNanos;

    ConversationState(TimeSource time, LineTimes times) {
        this.time = time;
        this.timeoutNanos = (long) (times.answerSeconds() * 1e9);
        this.unanswered = new UnansweredCommands(times.stallSeconds());
        this.answeredNanos = time.nanos();
        this.settling = new LineRecovery(answeredNanos);
    }

    MotionState stillness() {
        return stillness;
    }

    LineRecovery settling() {
        return settling;
    }

    UnansweredCommands unanswered() {
        return unanswered;
    }

    LinkQuality quality() {
        return meter.read();
    }

    /** Whether it was told to stand, confirmed that, and has been told nothing else since. */
    boolean isStanding() {
        return !stillness.mayMove() && !isStopping() && !endedInStop;
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
        if (ended != null) {
            return;
        }
        Exchange open = inFlight;
        if (open != null && open.purpose() == Purpose.STOP) {
            queue.discard(Purpose.MOTION, "stopped");
        } else {
            queue.stop(wayToStop());
        }
    }

    private Question wayToStop() {
        return stillness.isBrief() ? Question.VERIFY : Question.STOP;
    }

    void end(String why) {
        endedInStop |= isStopping();
        ended = why;
        dropInFlight(why);
        queue.discardAll(why);
    }

    /** What is to be sent now; null if nothing waits or the line is not free. Whoever gets it sends it. */
    @Nullable
    Exchange next() {
        long now = time.nanos();
        Exchange open = inFlight;
        Exchange next = firstFitting();
        if (next == null || !(open == null ? settling.isOver(now) : overtakes(next, open, now))) {
            return null;
        }
        if (!unanswered.admits(wording(next), now)) {
            return null;
        }
        queue.next();
        send(next, now);
        return next;
    }

    private void send(Exchange next, long now) {
        String wording = wording(next);
        if (next.sendings() > 0) {
            meter.repeated();
        }
        overtaken = inFlight;
        inFlight = next;
        unanswered.sent(next.question(), wording, now);
        stillness.sent(next.purpose());
        next.sent(wording, now);
    }

    /** A stop does not wait longer than a moment for an answer where the robot survives it. */
    private boolean overtakes(Exchange next, Exchange open, long now) {
        boolean soon = open.question().isAnsweredBriefly() || now - open.sentNanos() >= STOP_WAITS_NANOS;
        return next.purpose() == Purpose.STOP && soon && open.isWritten() && !open.isOfStop();
    }

    private String wording(Exchange next) {
        Question question = next.question();
        if (question == Question.STOP && unanswered.carryAStop()) {
            return Question.BRIEF_STOP;
        }
        boolean carries = question.canCarryAStop() && stillness.mayMove() && unanswered.isKTeams();
        return carries ? question.carryingAStop() : question.text();
    }

    /** What has been waiting since before the robot began to move may be too long by now. */
    private @Nullable Exchange firstFitting() {
        Exchange first = queue.first();
        while (first != null && first.question().isLong() && stillness.mayMove()) {
            queue.next();
            first.failed(TOO_LONG);
            first = queue.first();
        }
        return first;
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
        long now = time.nanos();
        if (open == null || !open.isWritten() || !isOverdue(open, now)) {
            return Outcome.NONE;
        }
        meter.missed(now);
        LOG.log(Level.DEBUG, "no answer to {0}", open.text());
        return giveUp(open, "no answer within " + timeoutNanos / 1_000_000 + " ms");
    }

    /** A stop is overdue as soon as it may be sent again. */
    private boolean isOverdue(Exchange open, long now) {
        long waitedNanos = now - open.sentNanos();
        return open.purpose() == Purpose.STOP
                ? waitedNanos >= STOP_AGAIN_NANOS && unanswered.admits(Question.STOP.text(), now)
                : waitedNanos >= timeoutNanos;
    }

    private Outcome gotAnswer(Reply reply) {
        unanswered.answered(reply);
        Exchange open = answeredBy(reply);
        if (open == null) {
            LOG.log(Level.DEBUG, "dropped, answers nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        close(open, reply);
        meter.answered(open.roundTripNanos());
        switch (stillness.answered(open.purpose(), reply, answeredNanos)) {
            case VERIFY -> queue.addFirst(new Exchange(Question.VERIFY));
            case VERIFY_LATER -> {
                settling.begin(answeredNanos);
                queue.addFirst(new Exchange(Question.VERIFY));
            }
            case STOP -> stop();
            case STOP_LATER -> {
                settling.begin(answeredNanos);
                queue.stopBehindFirst(wayToStop());
            }
            case NOTHING -> LOG.log(Level.TRACE, "nothing follows");
        }
        return Outcome.answered(open);
    }

    /** The robot answers in the order in which it was asked. */
    private @Nullable Exchange answeredBy(Reply reply) {
        Exchange before = overtaken;
        if (before != null && before.question().isAnsweredBy(reply)) {
            return before;
        }
        Exchange open = inFlight;
        return open != null && open.question().isAnsweredBy(reply) ? open : null;
    }

    private void close(Exchange open, Reply reply) {
        answeredNanos = time.nanos();
        open.answered(reply, answeredNanos);
        leave(open, OVERTAKEN);
    }

    /** What was overtaken goes before what overtook it, and is over with that at the latest. */
    private void leave(Exchange open, String why) {
        Exchange before = overtaken;
        overtaken = null;
        if (open == inFlight) {
            inFlight = null;
            if (before != null) {
                before.failed(why);
            }
        }
    }

    private void dropInFlight(String why) {
        Exchange open = inFlight;
        if (open != null) {
            open.failed(why);
            leave(open, why);
        }
    }

    private void stopAfterAPause() {
        settling.begin(time.nanos());
        stop();
    }

    private Outcome gotRefusal(Reply reply) {
        unanswered.damagedAnswer();
        Exchange open = overtaken == null ? inFlight : overtaken;
        if (open == null) {
            LOG.log(Level.DEBUG, "dropped, refuses nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        if (open.purpose() != Purpose.VERIFY && open.question() != Question.NOTHING) {
            answeredNanos = time.nanos();
            open.refused();
            return giveUp(open, "the robot refused " + open.text() + ": " + reply.text());
        }
        close(open, reply);
        if (open.purpose() == Purpose.VERIFY) {
            stillness.cannotTell();
        }
        return Outcome.answered(open);
    }

    /** The robot was switched on or reset: its motors stand, and what was asked before is forgotten (sheet 11). */
    private Outcome gotGreeting() {
        dropInFlight(Exchange.RESET);
        unanswered.clear();
        queue.discardAll(Exchange.RESET);
        stillness.wasReset();
        stopAfterAPause();
        return Outcome.RESET;
    }

    /** Decides what becomes of a question without answer. Nothing that moves survives it: nothing resumes by itself. */
    private Outcome giveUp(Exchange open, String why) {
        leave(open, why);
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
