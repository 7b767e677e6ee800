package majic.hemisson.line;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.hemisson.line.Question.Purpose;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Decides what is sent next and processes the answers: one question at a time, a stop before all others and again until
 * it is confirmed, nothing long while the robot may move. Sends nothing itself. Guarded by its owner.
 *
 * <p>A line that stalls may deliver a question and the stop behind it together, and the stop would deafen a robot that
 * answers the question. So a question to a moving robot carries the arguments of a stop, "N,0,0", which the robot
 * ignores and keeps; behind it "D" alone is a stop, and its two characters fit into the receiver. Nothing follows those
 * two until an answer arrives or the line counts as empty.
 */
final class ConversationState {
    private static final Logger LOG = System.getLogger(ConversationState.class.getName());

    private static final int MOST_SENDINGS = 2;

    /** How soon a stop goes out behind a question whose answer does not come, ns. */
    private static final long STOP_WAITS_NANOS = 100_000_000;

    /** How soon a stop is sent again, ns. */
    private static final long STOP_AGAIN_NANOS = 300_000_000;

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
    private final MotionState motion = new MotionState();
    private final OpenExchanges open = new OpenExchanges();
    private final LineRecovery recovery;
    private @Nullable String ended;
    private boolean endedInStop;
    private long answeredNanos;

    ConversationState(TimeSource time, LineTimes times) {
        this.time = time;
        this.timeoutNanos = (long) (times.answerSeconds() * 1e9);
        this.unanswered = new UnansweredCommands(times.stallSeconds());
        this.answeredNanos = time.nanos();
        this.recovery = new LineRecovery(answeredNanos);
    }

    MotionState motion() {
        return motion;
    }

    LineRecovery recovery() {
        return recovery;
    }

    UnansweredCommands unanswered() {
        return unanswered;
    }

    LinkQuality quality() {
        return meter.read();
    }

    /** Whether a stop is confirmed and nothing was sent since that could move the robot. */
    boolean isStopped() {
        return !motion.mayMove() && !isStopping() && !endedInStop;
    }

    long silentNanos() {
        return time.nanos() - answeredNanos;
    }

    /** Adds a question to the queue, or refuses it at once. */
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
        if (question.purpose() == Purpose.MOTION && motion.isDoubtful() && isStopping()) {
            return "it has not yet confirmed the stop";
        }
        if (motion.isBrief() && !question.isBrief()) {
            return DEAFENING;
        }
        return question.isLong() && motion.mayMove() ? TOO_LONG : null;
    }

    void stop() {
        if (ended != null) {
            return;
        }
        Exchange newest = open.newest();
        if (newest != null && newest.purpose() == Purpose.STOP) {
            queue.discard(Purpose.MOTION, "stopped");
        } else {
            queue.stop(wayToStop());
        }
    }

    private Question wayToStop() {
        return motion.isBrief() ? Question.VERIFY : Question.STOP;
    }

    void end(String why) {
        endedInStop |= isStopping();
        ended = why;
        open.discard(why);
        queue.discardAll(why);
    }

    /** The question to be sent now, which counts as sent; null if none waits or the line is not free. */
    @Nullable
    Exchange next() {
        long now = time.nanos();
        Exchange before = open.newest();
        Exchange next = firstFitting();
        if (next == null || !(before == null ? recovery.isOver(now) : overtakes(next, before, now))) {
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
        open.sent(next);
        unanswered.sent(next.question(), wording, now);
        motion.sent(next.purpose());
        next.sent(wording, now);
    }

    /** A stop waits for an answer only for a moment, where the receiver survives it. */
    private boolean overtakes(Exchange next, Exchange before, long now) {
        boolean soon = before.question().isAnsweredBriefly() || now - before.sentNanos() >= STOP_WAITS_NANOS;
        return next.purpose() == Purpose.STOP && soon && before.isWritten() && !before.isOfStop();
    }

    private String wording(Exchange next) {
        return unanswered.wording(next.question(), motion.mayMove());
    }

    /** The first question that may be sent; discards those that became too long when the robot began to move. */
    private @Nullable Exchange firstFitting() {
        Exchange first = queue.first();
        while (first != null && first.question().isLong() && motion.mayMove()) {
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

    /** Gives up a question whose answer is overdue. */
    Outcome overdue() {
        Exchange newest = open.newest();
        long now = time.nanos();
        if (newest == null || !newest.isWritten() || !isOverdue(newest, now)) {
            return Outcome.NONE;
        }
        meter.missed(now);
        LOG.log(Level.DEBUG, "no answer to {0}", newest.text());
        return giveUp(newest, "no answer within " + timeoutNanos / 1_000_000 + " ms");
    }

    /** A stop is overdue as soon as it may be sent again. */
    private boolean isOverdue(Exchange sent, long now) {
        long waitedNanos = now - sent.sentNanos();
        return sent.purpose() == Purpose.STOP
                ? waitedNanos >= STOP_AGAIN_NANOS && unanswered.admits(Question.STOP.text(), now)
                : waitedNanos >= timeoutNanos;
    }

    private Outcome gotAnswer(Reply reply) {
        unanswered.answered(reply);
        Exchange answered = open.answeredBy(reply);
        if (answered == null) {
            LOG.log(Level.DEBUG, "dropped, answers nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        close(answered, reply);
        meter.answered(answered.roundTripNanos());
        switch (motion.answered(answered.purpose(), reply, answeredNanos)) {
            case VERIFY -> queue.addFirst(new Exchange(Question.VERIFY));
            case VERIFY_LATER -> {
                recovery.begin(answeredNanos);
                queue.addFirst(new Exchange(Question.VERIFY));
            }
            case STOP -> stop();
            case STOP_LATER -> {
                recovery.begin(answeredNanos);
                queue.stopBehindFirst(wayToStop());
            }
            case NOTHING -> LOG.log(Level.TRACE, "nothing follows");
        }
        return Outcome.answered(answered);
    }

    private void close(Exchange answered, Reply reply) {
        answeredNanos = time.nanos();
        answered.answered(reply, answeredNanos);
        open.remove(answered);
    }

    private void stopAfterAPause() {
        recovery.begin(time.nanos());
        stop();
    }

    private Outcome gotRefusal(Reply reply) {
        unanswered.damagedAnswer();
        Exchange oldest = open.oldest();
        if (oldest == null) {
            LOG.log(Level.DEBUG, "dropped, refuses nothing: {0}", reply.text());
            return Outcome.NONE;
        }
        if (oldest.purpose() != Purpose.VERIFY && oldest.question() != Question.NOTHING) {
            answeredNanos = time.nanos();
            oldest.refused();
            return giveUp(oldest, "the robot refused " + oldest.text() + ": " + reply.text());
        }
        close(oldest, reply);
        if (oldest.purpose() == Purpose.VERIFY) {
            motion.cannotTell();
        }
        return Outcome.answered(oldest);
    }

    /** The robot was switched on or reset: its motors are off, and the open questions are discarded (sheet 11). */
    private Outcome gotGreeting() {
        open.discard(Exchange.RESET);
        unanswered.clear();
        queue.discardAll(Exchange.RESET);
        motion.wasReset();
        stopAfterAPause();
        return Outcome.RESET;
    }

    /** Handles a question without answer. All motions are discarded, so that none resumes by itself. */
    private Outcome giveUp(Exchange missed, String why) {
        open.remove(missed, why);
        recovery.begin(time.nanos());
        motion.missed();
        queue.discard(Purpose.MOTION, why);
        if (mayRepeat(missed)) {
            queue.repeat(missed);
        } else {
            missed.failed(why);
        }
        boolean inMotion = motion.mayMove();
        if (inMotion || missed.isOfStop()) {
            stop();
        }
        return Outcome.missed(missed, inMotion);
    }

    private boolean mayRepeat(Exchange missed) {
        boolean once = missed.purpose() == Purpose.ASK && missed.sendings() < MOST_SENDINGS;
        return once && !motion.mayMove() && missed.question() != Question.NOTHING;
    }

    private boolean isStopping() {
        Exchange newest = open.newest();
        return (newest != null && newest.isOfStop()) || queue.holds(Purpose.STOP) || queue.holds(Purpose.VERIFY);
    }
}
