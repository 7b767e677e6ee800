package majic.hemisson.line;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.hemisson.line.Question.Purpose;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Processes questions, answers and timeouts of one conversation; a stop is sent before all other questions and again
 * until it is confirmed, nothing long while the robot may move. Sends nothing itself. Guarded by its owner.
 *
 * <p>A line that stalls may deliver a question and the stop behind it together, and the stop would deafen a robot that
 * answers the question. So a question to a moving robot carries the arguments of a stop, "N,0,0", which the robot
 * ignores and keeps; behind it "D" alone is a stop, and its two characters fit into the receiver. Nothing follows those
 * two until an answer arrives or the line counts as empty.
 */
final class ConversationState {
    private static final Logger LOG = System.getLogger(ConversationState.class.getName());

    private static final int MOST_SENDINGS = 2;

    /** How soon a stop is sent again, ns. */
    private static final long STOP_AGAIN_NANOS = 300_000_000;

    private static final String DEAFENING =
            "its switches select no running mode, and a command so long could deafen it; put all four to the side that "
                    + "reads 1 and switch it off and on";

    private final TimeSource time;
    private final long timeoutNanos;
    private final UnansweredCommands unanswered;
    private final ExchangeQueue queue = new ExchangeQueue();
    private final LinkQuality.Meter meter = new LinkQuality.Meter();
    private final MotionState motion = new MotionState();
    private final StopSequence stops = new StopSequence(motion);
    private final OpenExchanges open = new OpenExchanges();
    private final LineRecovery recovery;
    private final SendOrder order;
    private @Nullable String ended;
    private boolean endedInStop;
    private long answeredNanos;
    private @Nullable Exchange firstStop;

    ConversationState(TimeSource time, LineTimes times) {
        this.time = time;
        this.timeoutNanos = (long) (times.answerSeconds() * 1e9);
        this.unanswered = new UnansweredCommands(times.stallSeconds());
        this.answeredNanos = time.nanos();
        this.recovery = new LineRecovery(answeredNanos);
        this.order = new SendOrder(queue, open, unanswered, motion, recovery);
    }

    MotionState motion() {
        return motion;
    }

    StopSequence stops() {
        return stops;
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
        if (stops.isDeafenable() && !question.isBrief()) {
            return DEAFENING;
        }
        return question.isLong() && motion.mayMove() ? SendOrder.TOO_LONG : null;
    }

    /**
     * Adds a stop before all other questions, unless one is being sent or verified already: nothing that moves the
     * robot is sent before the verification is answered, and if it is not answered with zeros, another stop follows.
     */
    void stop() {
        if (ended != null) {
            return;
        }
        Exchange newest = open.newest();
        if (newest != null && newest.isOfStop()) {
            queue.discard(Purpose.MOTION, "stopped");
        } else {
            queue.stop(stops.stop());
        }
    }

    /** Ends all exchanges; later questions fail with this cause. */
    void end(String why) {
        endedInStop |= isStopping();
        ended = why;
        open.discard(why);
        queue.discardAll(why);
    }

    /** The question to be sent now, which counts as sent; null if none waits or the line is not free. */
    @Nullable
    Exchange next() {
        Exchange next = order.next(time.nanos());
        if (next != null && next.sendings() > 1) {
            meter.repeated();
        }
        if (next != null && next.purpose() == Purpose.STOP) {
            stopSent(next);
        }
        return next;
    }

    private void stopSent(Exchange stop) {
        Exchange first = firstStop;
        if (first == null) {
            firstStop = stop;
        } else {
            stop.repeats(first.sentNanos());
        }
    }

    /** Processes a line from the robot. */
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
        LOG.log(Level.DEBUG, "no answer to {0}", newest.text());
        if (now - newest.askedNanos() < timeoutNanos) {
            repeatStop(newest);
            return Outcome.NONE;
        }
        meter.missed(now);
        return giveUp(newest, "no answer within " + timeoutNanos / 1_000_000 + " ms");
    }

    /** A stop is repeated before its answer counts as missed. */
    private void repeatStop(Exchange unanswered) {
        open.remove(unanswered);
        unanswered.failed("repeated");
        motion.doubt();
        stopAfterAPause();
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
        switch (stops.answered(answered.purpose(), reply, answeredNanos)) {
            case VERIFY -> queue.addFirst(new Exchange(Question.VERIFY));
            case VERIFY_LATER -> {
                recovery.begin(answeredNanos);
                queue.addFirst(new Exchange(Question.VERIFY));
            }
            case STOP -> stop();
            case STOP_LATER -> {
                recovery.begin(answeredNanos);
                queue.stopBehindFirst(stops.stop());
            }
            case NOTHING -> {}
        }
        return Outcome.answered(answered);
    }

    private void close(Exchange answered, Reply reply) {
        answeredNanos = time.nanos();
        answered.answered(reply, answeredNanos);
        firstStop = answered.purpose() == Purpose.STOP ? null : firstStop;
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
            stops.speedsRefused();
        }
        return Outcome.answered(oldest);
    }

    /** The robot was switched on or reset: its motors are off, and the open questions are discarded (sheet 11). */
    private Outcome gotGreeting() {
        open.discard(Exchange.RESET);
        unanswered.clear();
        firstStop = null;
        queue.discardAll(Exchange.RESET);
        stops.wasReset();
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
