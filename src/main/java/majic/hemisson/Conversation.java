package majic.hemisson;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.TimeSource;
import majic.hemisson.Question.Purpose;
import majic.link.Link;
import org.jspecify.annotations.Nullable;

/**
 * One question at a time, as the robot needs it: its receiver holds two characters, and whoever talks into an answer
 * deafens it until it is switched off (Hemisson sheet 4.4). So even a stop waits for the answer under way; it takes the
 * very next turn and is repeated until it is answered.
 *
 * <p>Thread-safe. Nothing here waits: a question is written by whoever asks when the line is free, else by the reader
 * when the answer under way has come, or by {@link #tick} when that is overdue and the line has been quiet for a while.
 */
final class Conversation {
    private static final Logger LOG = System.getLogger(Conversation.class.getName());

    /** How long the line must have been quiet after a missed answer before it is used again (sheet 4.6). */
    static final long QUIET_NANOS = 100_000_000;

    private static final int MOST_SENDINGS = 2;

    private final Link link;
    private final TimeSource time;
    private final long timeoutNanos;
    private final ConversationListener listener;
    private final Object lock = new Object();
    private final ExchangeQueue queue = new ExchangeQueue();
    private final LinkQuality.Meter meter = new LinkQuality.Meter();
    private @Nullable Exchange inFlight;
    private boolean settling;
    private boolean mayMove;
    private boolean doubtful;
    private long heardNanos;
    private long answeredNanos;

    Conversation(Link link, TimeSource time, double timeoutSeconds, ConversationListener listener) {
        this.link = link;
        this.time = time;
        this.timeoutNanos = (long) (timeoutSeconds * 1e9);
        this.listener = listener;
        this.answeredNanos = time.nanos();
        this.heardNanos = answeredNanos;
    }

    /**
     * Asks something as soon as it is its turn.
     *
     * @return the exchange, to be looked at when it is done
     */
    Exchange ask(Question question) {
        Exchange exchange = new Exchange(question);
        synchronized (lock) {
            if (question.purpose() == Purpose.MOTION && doubtful && isStopping()) {
                exchange.failed("it has not yet confirmed the stop");
                return exchange;
            }
            if (question.purpose() == Purpose.MOTION) {
                queue.discard(Purpose.MOTION, "replaced");
            }
            queue.add(exchange);
        }
        sendNext();
        return exchange;
    }

    /** Lets the robot stand: at once if the line is free, else right behind the answer under way. */
    void stop() {
        synchronized (lock) {
            stopLocked();
        }
        sendNext();
    }

    /** Whether it was told to stand, confirmed that, and has been told nothing else since. */
    boolean isStanding() {
        synchronized (lock) {
            return !mayMove && !isStopping();
        }
    }

    /** Whether the wheels may turn now. */
    boolean mayMove() {
        synchronized (lock) {
            return mayMove;
        }
    }

    /** How long no question has been answered, seconds; only of interest while some are asked. */
    double silentSeconds() {
        synchronized (lock) {
            return (time.nanos() - answeredNanos) / 1e9;
        }
    }

    /** Whether nothing has come in for a while. */
    boolean isQuiet() {
        synchronized (lock) {
            return time.nanos() - heardNanos >= QUIET_NANOS;
        }
    }

    LinkQuality quality() {
        synchronized (lock) {
            return meter.read();
        }
    }

    /** To be called by the reader whenever bytes came, whatever they are. */
    void heard() {
        synchronized (lock) {
            heardNanos = time.nanos();
        }
    }

    /** Takes a line from the robot. Called by the reader. */
    void received(Reply reply) {
        LOG.log(Level.TRACE, "< {0}", reply.text());
        if (reply.kind() == Reply.Kind.GREETING) {
            gotGreeting();
        } else if (reply.kind() == Reply.Kind.REFUSED) {
            gotRefusal(reply);
        } else {
            gotAnswer(reply);
        }
    }

    /** Looks for answers that are overdue. To be called a few times within their time-out. */
    void tick() {
        Exchange missed = null;
        synchronized (lock) {
            Exchange open = inFlight;
            if (open != null && time.nanos() - open.sentNanos() >= timeoutNanos) {
                missed = open;
                meter.missed(time.nanos());
                LOG.log(Level.DEBUG, "no answer to {0}", open.question().text());
                giveUp(open, "no answer within " + timeoutNanos / 1_000_000 + " ms");
            }
        }
        if (missed != null) {
            listener.missed(missed);
        }
        sendNext();
    }

    /** Ends everything that waits; nothing can be asked any more. */
    void end(String why) {
        synchronized (lock) {
            if (inFlight != null) {
                inFlight.failed(why);
            }
            queue.discardAll(why);
        }
    }

    private void gotAnswer(Reply reply) {
        Exchange answered;
        synchronized (lock) {
            answered = inFlight;
            if (answered == null || !answered.question().isAnsweredBy(reply)) {
                LOG.log(Level.DEBUG, "dropped, answers nothing: {0}", reply.text());
                return;
            }
            inFlight = null;
            answeredNanos = time.nanos();
            answered.answered(reply, answeredNanos);
            meter.answered(answered.roundTripNanos());
            concludeStop(answered, reply);
        }
        sendNext();
        listener.answered(answered);
    }

    private void gotRefusal(Reply reply) {
        Exchange refused;
        synchronized (lock) {
            refused = inFlight;
            if (refused == null) {
                LOG.log(Level.DEBUG, "dropped, refuses nothing: {0}", reply.text());
                return;
            }
            answeredNanos = time.nanos();
            if (refused.purpose() == Purpose.VERIFY) {
                inFlight = null;
                stands();
            } else if (refused.question() == Question.NOTHING) {
                inFlight = null;
                refused.answered(reply, answeredNanos);
            } else {
                giveUp(refused, "the robot refused " + refused.question().text());
            }
        }
        sendNext();
        if (refused.reply() != null || refused.purpose() == Purpose.VERIFY) {
            listener.answered(refused);
        } else {
            listener.missed(refused);
        }
    }

    /** The robot was switched on or reset: its motors stand, and what was asked before is forgotten (sheet 11). */
    private void gotGreeting() {
        synchronized (lock) {
            Exchange open = inFlight;
            inFlight = null;
            settling = true;
            if (open != null) {
                open.failed("the robot was reset");
            }
            queue.discardAll("the robot was reset");
            stopLocked();
        }
        listener.wasReset();
    }

    /** Decides what becomes of a question without answer. Nothing that moves survives it: nothing resumes by itself. */
    private void giveUp(Exchange open, String why) {
        inFlight = null;
        settling = true;
        doubtful = true;
        queue.discard(Purpose.MOTION, why);
        boolean mayRepeat = open.purpose() == Purpose.ASK && open.sendings() < MOST_SENDINGS;
        if (open.purpose() == Purpose.STOP) {
            queue.addFirst(open);
        } else if (mayRepeat && !mayMove && open.question() != Question.NOTHING) {
            queue.addFirst(open);
        } else {
            open.failed(why);
        }
        if (mayMove) {
            stopLocked();
        }
    }

    private void stopLocked() {
        Exchange open = inFlight;
        if (open != null && open.purpose() == Purpose.STOP) {
            queue.discard(Purpose.MOTION, "stopped");
        } else {
            queue.stop();
        }
    }

    /**
     * The answer to a stop is one letter, and after missed answers it could be a late one to an earlier command; nor does
     * it tell whether the digits arrived whole. So a robot that may have moved is asked for its speeds as well.
     */
    private void concludeStop(Exchange answered, Reply reply) {
        boolean verified = answered.purpose() == Purpose.VERIFY;
        if (answered.purpose() == Purpose.STOP && (doubtful || mayMove)) {
            queue.addFirst(new Exchange(Question.VERIFY));
        } else if (verified && reply.numbers().stream().anyMatch(speed -> speed != 0)) {
            queue.stop();
        } else if (verified || answered.purpose() == Purpose.STOP) {
            stands();
        }
    }

    private void stands() {
        doubtful = false;
        mayMove = false;
    }

    private boolean isStopping() {
        Exchange open = inFlight;
        boolean stopInFlight = open != null && isOfStop(open.purpose());
        return stopInFlight || queue.holds(Purpose.STOP) || queue.holds(Purpose.VERIFY);
    }

    private static boolean isOfStop(Purpose purpose) {
        return purpose == Purpose.STOP || purpose == Purpose.VERIFY;
    }

    private void sendNext() {
        Exchange next = takeNext();
        if (next == null) {
            return;
        }
        LOG.log(Level.TRACE, "> {0}", next.question().text());
        try {
            link.write(next.question().bytes());
        } catch (IOException e) {
            listener.broken(e);
        }
    }

    /** Takes the line for the next question, if it is free; the writing is then done without the lock. */
    private @Nullable Exchange takeNext() {
        synchronized (lock) {
            if (inFlight != null || (settling && !isQuiet())) {
                return null;
            }
            settling = false;
            Exchange next = queue.next();
            if (next != null) {
                inFlight = next;
                if (next.sendings() > 0) {
                    meter.repeated();
                }
                mayMove |= next.purpose() == Purpose.MOTION;
                next.sent(time.nanos());
            }
            return next;
        }
    }
}
