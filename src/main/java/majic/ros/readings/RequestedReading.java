package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.function.Function;
import majic.bot.BotException;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.ros.bridge.TopicSubscription;
import majic.ros.message.UnusableMessage;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * A reading of a topic that is subscribed to only while something reads it: the first read subscribes, and the
 * subscription ends when nothing has read for some seconds. Threads that only observe do not count. Thread-safe.
 *
 * @param <T> the reading, immutable
 */
public final class RequestedReading<T> {
    /** A publisher is found and its first message arrives within less; slow topics have one message a second. */
    private static final double FIRST_S = 3;

    private final RosClient connection;
    private final TopicSubscription wanted;
    private final Function<JsonNode, T> reader;
    private final RobotWait waiting;
    private final double unusedS;
    private volatile Newest<T> newest;
    private volatile @Nullable String unusable;
    private volatile long readNanos;
    private long subscribedNanos;
    private @Nullable Runnable unsubscribe;

    /**
     * A reading that nothing has read yet.
     *
     * @param reader makes the reading of a message; throws {@link UnusableMessage}
     * @param waiting the robot's clock and signal
     * @param unusedS how long the subscription continues without a read, s
     */
    RequestedReading(
            RosClient connection,
            TopicSubscription wanted,
            Function<JsonNode, T> reader,
            RobotWait waiting,
            double unusedS) {
        this.connection = connection;
        this.wanted = wanted;
        this.reader = reader;
        this.waiting = waiting;
        this.unusedS = unusedS;
        this.newest = nothing();
    }

    /** A topic without a message for so long has stopped, whatever its rate. */
    private Newest<T> nothing() {
        return new Newest<>(waiting.time(), FIRST_S);
    }

    /**
     * Reads; subscribes at first, and waits then for the first message if the thread may wait.
     *
     * @return empty if no message has arrived, or none of late
     * @throws BotException if the connection is lost
     */
    public Optional<T> read() {
        if (WaitPolicy.isObserving()) {
            return newest.get();
        }
        readNanos = waiting.time().nanos();
        double leftS = FIRST_S - subscribe();
        if (leftS > 0 && WaitPolicy.isAllowed()) {
            waiting.await(() -> newest.get().isPresent() || unusable != null, leftS);
        }
        return newest.get();
    }

    /**
     * Keeps the subscription for some seconds, as a read does, and waits for nothing. It may be sent, which blocks for
     * as long as the connection does not take it.
     *
     * @throws BotException if the connection is lost
     */
    public void request() {
        readNanos = waiting.time().nanos();
        subscribe();
    }

    /** Subscribes if necessary; returns for how many seconds the subscription has existed. */
    private synchronized double subscribe() {
        if (unsubscribe == null) {
            subscribedNanos = waiting.time().nanos();
            unsubscribe = connection.subscribe(wanted, this::arrived);
        }
        return waiting.time().secondsSince(subscribedNanos);
    }

    private void arrived(JsonNode message) {
        try {
            newest.arrived(reader.apply(message));
            unusable = null;
        } catch (UnusableMessage e) {
            unusable = e.getMessage();
        }
        waiting.changes().raise();
    }

    /**
     * Returns why there is no reading.
     *
     * @return an unknown value
     */
    public Value unknown() {
        String wrong = unusable;
        return wrong == null
                ? newest.unknown()
                : Value.unknown("the topic " + wanted.topic() + " is unusable: " + wrong);
    }

    /**
     * Returns the age of the newest message.
     *
     * @return s since its arrival; positive infinity without one
     */
    public double ageS() {
        return newest.ageS();
    }

    /** Ends the subscription if nothing has read for some time. */
    synchronized void endIfUnused() {
        Runnable end = unsubscribe;
        if (end != null && waiting.time().secondsSince(readNanos) > unusedS) {
            unsubscribe = null;
            newest = nothing();
            unusable = null;
            end.run();
        }
    }
}
