package majic.hemisson.line;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.link.Link;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Sends the questions of a {@link ConversationState} over a link. The robot's receiver holds two characters, and a
 * third one that arrives while it answers deafens it until it is switched off (Hemisson sheet 4.4). So even a stop
 * waits a moment for the answer under way; it is sent before all other questions and repeated until it is answered.
 *
 * <p>Thread-safe. Never blocks: a question is written by the calling thread when the line is free, else by the reader
 * when the answer under way has come, or by {@link #tick} when that is overdue and the line has been quiet for a while.
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
     * Adds a question, which is sent when its turn comes.
     *
     * @return the exchange, which can be checked for its answer
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
     * Stops the robot: at once if the line is free, else right behind the answer under way, or before that where the
     * receiver survives it.
     */
    public void stop() {
        synchronized (lock) {
            state.stop();
        }
        sendNext();
    }

    /** Sets whether more than two characters may deafen the robot; true at first. */
    public void setDeafenable(boolean now) {
        synchronized (lock) {
            state.stops().setDeafenable(now);
        }
    }

    /** Sets whether the robot's running mode overrides the speeds that were sent. */
    public void setOwnSpeeds(boolean now) {
        synchronized (lock) {
            state.stops().setOwnSpeeds(now);
        }
    }

    /** Whether the robot's running mode overrides the speeds that were sent. */
    boolean hasOwnSpeeds() {
        synchronized (lock) {
            return state.stops().hasOwnSpeeds();
        }
    }

    /** Whether the running mode sets speeds, and has done so after a stop. */
    public boolean isOverridden() {
        synchronized (lock) {
            return state.stops().isOverridden();
        }
    }

    /** How often the robot has confirmed that it is stopped. */
    long confirmations() {
        synchronized (lock) {
            return state.motion().confirmations();
        }
    }

    /** Sets what the robot's receiver survives; {@link ReceiverLimits#UNKNOWN} at first. */
    void receiver(ReceiverLimits known) {
        synchronized (lock) {
            state.unanswered().receiver(known);
        }
    }

    /** Whether a stop is confirmed and nothing was sent since that could move the robot. */
    public boolean isStopped() {
        synchronized (lock) {
            return state.isStopped();
        }
    }

    /**
     * Whether a stop is confirmed, and since then no answer was missed and nothing was sent that could move the robot.
     */
    boolean isCertainlyStopped() {
        synchronized (lock) {
            return state.isStopped() && !state.motion().isDoubtful();
        }
    }

    /** Whether the wheels may turn now. */
    public boolean mayMove() {
        synchronized (lock) {
            return state.motion().mayMove();
        }
    }

    /** Whether it may move, and has missed an answer since it began to. */
    public boolean isUnreached() {
        synchronized (lock) {
            return state.motion().isUnreached();
        }
    }

    /** Time since the last answer, seconds; meaningful only while questions are sent. */
    public double silentSeconds() {
        synchronized (lock) {
            return state.silentNanos() / 1e9;
        }
    }

    /** Whether nothing was received for a while. */
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

    /** Records that bytes were received. Called by the reader. */
    void bytesReceived() {
        synchronized (lock) {
            state.recovery().bytesReceived(time.nanos());
        }
    }

    /** Processes a line from the robot. Called by the reader. */
    void received(Reply reply) {
        LOG.log(Level.TRACE, "< {0}", reply.text());
        Outcome outcome;
        synchronized (lock) {
            outcome = state.received(reply);
        }
        sendNext();
        outcome.deliver(listener);
    }

    /** Handles answers that are overdue. To be called several times within their timeout. */
    public void tick() {
        Outcome outcome;
        synchronized (lock) {
            outcome = state.overdue();
        }
        sendNext();
        outcome.deliver(listener);
    }

    /** Ends all exchanges; later questions fail. */
    void end(String why) {
        synchronized (lock) {
            state.end(why);
        }
    }

    /** Writes the next question if the line is free. The lock is not held while writing. */
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
