package majic.hemisson.line;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.link.Link;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A {@link ConversationState} over a link. The robot's receiver holds two characters, and a third one that arrives while it answers
 * deafens it until it is switched off (Hemisson sheet 4.4). So even a stop waits for the answer under way, for a moment;
 * it takes the very next turn and is repeated until it is answered.
 *
 * <p>Thread-safe. Nothing here waits: a question is written by the thread that asks when the line is free, else by the
 * reader when the answer under way has come, or by {@link #tick} when that is overdue and the line has been quiet for a while.
 */
public final class Conversation {
    private static final Logger LOG = System.getLogger(Conversation.class.getName());

    private final Link link;
    private final TimeSource time;
    private final ConversationListener listener;
    private final Object lock = new Object();
    private final ConversationState state;

    Conversation(Link link, TimeSource time, LineTimes times, ConversationListener listener) {
        this.link = link;
        this.time = time;
        this.listener = listener;
        this.state = new ConversationState(time, times);
    }

    /**
     * Asks something as soon as it is its turn.
     *
     * @return the exchange, to be looked at when it is done
     */
    public Exchange ask(Question question) {
        Exchange exchange;
        synchronized (lock) {
            exchange = state.ask(question);
        }
        sendNext();
        return exchange;
    }

    /**
     * Lets the robot stand: at once if the line is free, else right behind the answer under way, or before that where
     * the robot surely survives it.
     */
    public void stop() {
        synchronized (lock) {
            state.stop();
        }
        sendNext();
    }

    /** Takes note whether the robot is deafened by more than two characters; so it is taken to be at first. */
    public void brief(boolean now) {
        synchronized (lock) {
            state.motion().brief(now);
        }
    }

    /** Takes note whether the robot's running mode sets its speeds again after it was told others. */
    public void setsItsOwnSpeeds(boolean now) {
        synchronized (lock) {
            state.motion().setsItsOwnSpeeds(now);
        }
    }

    /** Whether its running mode may set its speeds again after it was told others. */
    boolean setsItsOwnSpeeds() {
        synchronized (lock) {
            return state.motion().setsItsOwnSpeeds();
        }
    }

    /** Whether it sets its own speeds, and was found to do so after it was told to stand. */
    public boolean isContrary() {
        synchronized (lock) {
            return state.motion().isContrary();
        }
    }

    /** How often it has confirmed that it stands. */
    long confirmations() {
        synchronized (lock) {
            return state.motion().confirmations();
        }
    }

    /** Sets what the robot's receiver survives; {@link Receiver#UNKNOWN} at first. */
    void receiver(Receiver known) {
        synchronized (lock) {
            state.unanswered().receiver(known);
        }
    }

    /** Whether it was told to stand, confirmed that, and has been told nothing else since. */
    public boolean isStanding() {
        synchronized (lock) {
            return state.isStanding();
        }
    }

    /** Whether the wheels may turn now. */
    public boolean mayMove() {
        synchronized (lock) {
            return state.motion().mayMove();
        }
    }

    /** Whether it may move though it has missed an answer since it began to. */
    public boolean isUnreached() {
        synchronized (lock) {
            return state.motion().isUnreached();
        }
    }

    /** How long no question has been answered, seconds; only of interest while some are asked. */
    public double silentSeconds() {
        synchronized (lock) {
            return state.silentNanos() / 1e9;
        }
    }

    /** Whether nothing has come in for a while. */
    boolean isQuiet() {
        synchronized (lock) {
            return state.recovery().isQuiet(time.nanos());
        }
    }

    public LinkQuality quality() {
        synchronized (lock) {
            return state.quality();
        }
    }

    /** To be called by the reader whenever bytes came, whatever they are. */
    void heard() {
        synchronized (lock) {
            state.recovery().heard(time.nanos());
        }
    }

    /** Takes a line from the robot. Called by the reader. */
    void received(Reply reply) {
        LOG.log(Level.TRACE, "< {0}", reply.text());
        Outcome outcome;
        synchronized (lock) {
            outcome = state.received(reply);
        }
        sendNext();
        outcome.tell(listener);
    }

    /** Looks for answers that are overdue. To be called a few times within their time-out. */
    public void tick() {
        Outcome outcome;
        synchronized (lock) {
            outcome = state.overdue();
        }
        sendNext();
        outcome.tell(listener);
    }

    /** Ends everything that waits; nothing can be asked any more. */
    void end(String why) {
        synchronized (lock) {
            state.end(why);
        }
    }

    /** Takes the line for the next question, if it is free; the writing is then done without the lock. */
    private void sendNext() {
        Exchange next = next();
        if (next == null) {
            return;
        }
        LOG.log(Level.TRACE, "> {0}", next.text());
        try {
            link.write(Question.bytes(next.text()));
            next.written();
        } catch (IOException e) {
            listener.broken(e);
        }
    }

    private @Nullable Exchange next() {
        synchronized (lock) {
            return state.next();
        }
    }
}
