package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import majic.bot.BotException;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicSubscription;
import majic.ros.message.UnusableMessage;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * A reading of a topic that is subscribed to only while something reads it: the first read subscribes, and the
 * subscription ends when nothing has read for some seconds. Threads that only observe do not count. Of a topic whose
 * size is not known the first read takes one message, and of one with large messages each read does. Thread-safe.
 *
 * @param <T> the reading, immutable
 */
public final class RequestedReading<T> {
    /** A publisher is found and its first message arrives within less; slow topics have one message a second. */
    private static final double FIRST_S = 3;

    /** So long a message is awaited that is arriving, seconds. */
    private static final double ARRIVING_S = 20;

    private static final double LOOK_S = 0.25;

    /** Messages that are longer are requested one by one, bytes. */
    private static final int LARGE_BYTES = 50_000;

    /** A message that is not older than this answers a read; the next one is not requested before, seconds. */
    private static final double NEW_S = 0.5;

    private static final double BYTES_PER_MB = 1e6;

    private final TopicSource source;
    private final TopicSubscription wanted;
    private final Function<JsonNode, T> reader;
    private final RobotWait waiting;
    private final double unusedS;
    private volatile Newest<T> newest;
    private volatile @Nullable String unusable;
    private volatile boolean single;
    private volatile long readNanos;
    private volatile long subscribedNanos;
    private @Nullable Runnable unsubscribe;

    private RequestedReading(
            TopicSource source,
            TopicSubscription wanted,
            Function<JsonNode, T> reader,
            RobotWait waiting,
            double unusedS,
            boolean single) {
        this.source = source;
        this.wanted = wanted;
        this.reader = reader;
        this.waiting = waiting;
        this.unusedS = unusedS;
        this.single = single;
        this.newest = nothing();
    }

    /**
     * A reading that nothing has read yet, of a topic whose messages are of a known size.
     *
     * @param reader makes the reading of a message; throws {@link UnusableMessage}
     * @param waiting the robot's clock and signal
     * @param unusedS how long the subscription continues without a read, s
     */
    static <T> RequestedReading<T> streamed(
            TopicSource source,
            TopicSubscription wanted,
            Function<JsonNode, T> reader,
            RobotWait waiting,
            double unusedS) {
        return new RequestedReading<>(source, wanted, reader, waiting, unusedS, false);
    }

    /** The same of any topic: the first message shows whether they are large. */
    static <T> RequestedReading<T> sampled(
            TopicSource source,
            TopicSubscription wanted,
            Function<JsonNode, T> reader,
            RobotWait waiting,
            double unusedS) {
        return new RequestedReading<>(source, wanted, reader, waiting, unusedS, true);
    }

    /** A topic without a message for so long has stopped, whatever its rate. */
    private Newest<T> nothing() {
        return new Newest<>(waiting.time(), FIRST_S);
    }

    /**
     * Reads; subscribes at first, and waits then for the first message if the thread may wait.
     *
     * @return empty if no message has arrived, or none of late
     * @throws BotException if the connection with the robot is lost
     */
    public Optional<T> read() {
        if (WaitPolicy.isObserving()) {
            return newest.get();
        }
        readNanos = waiting.time().nanos();
        subscribe();
        if (WaitPolicy.isAllowed()) {
            awaitFirst();
        }
        return newest.get();
    }

    private void awaitFirst() {
        waiting.await(this::isAnswered, FIRST_S - subscribedS());
        while (!isAnswered() && source.arriving().bytes() > 0 && subscribedS() < ARRIVING_S) {
            waiting.await(this::isAnswered, LOOK_S);
        }
    }

    private double subscribedS() {
        return waiting.time().secondsSince(subscribedNanos);
    }

    /** Whether a message has arrived since the subscription began, or just before. */
    private boolean isAnswered() {
        return unusable != null || newest.ageS() <= subscribedS() + NEW_S;
    }

    /** Keeps the subscription for some seconds, as a read does, and waits for nothing. */
    public void request() {
        readNanos = waiting.time().nanos();
        subscribe();
    }

    private synchronized void subscribe() {
        if (unsubscribe == null && !(single && newest.ageS() < NEW_S)) {
            subscribedNanos = waiting.time().nanos();
            unusable = null;
            unsubscribe = source.subscribe(single ? wanted.once() : wanted, new Arrivals());
        }
    }

    /** Ends the subscription to one message that has arrived; the topic is read like the others if it was small. */
    private synchronized void endSingle(int bytes) {
        Runnable end = unsubscribe;
        if (single && end != null) {
            unsubscribe = null;
            single = bytes > LARGE_BYTES;
            end.run();
        }
    }

    /**
     * Returns why there is no reading.
     *
     * @return an unknown value
     */
    public Value unknown() {
        String wrong = unusable;
        if (wrong != null) {
            return Value.unknown("the topic " + wanted.topic() + " is unusable: " + wrong);
        }
        Arriving arriving = source.arriving();
        if (arriving.bytes() > 0) {
            return Value.unknown("the topic " + wanted.topic() + " is large or the connection slow: "
                    + megabytes(arriving.bytes()) + " of " + megabytes(arriving.of()) + " MB have arrived");
        }
        return arriving.leftOut()
                ? Value.unknown("the topic " + wanted.topic() + " is large: messages of more than "
                        + (RosBridge.LONGEST_MESSAGE >> 20) + " MB are left out")
                : newest.unknown();
    }

    private static String megabytes(long bytes) {
        return String.format(Locale.ROOT, "%.1f", bytes / BYTES_PER_MB);
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
        boolean arrives = single && source.arriving().bytes() > 0;
        if (end != null && !arrives && waiting.time().secondsSince(readNanos) > unusedS) {
            unsubscribe = null;
            newest = nothing();
            unusable = null;
            end.run();
        }
    }

    /** Handles what arrives. */
    private final class Arrivals implements TopicSource.Receiver {
        @Override
        public void message(JsonNode message, int bytes) {
            try {
                newest.arrived(reader.apply(message));
                unusable = null;
            } catch (UnusableMessage e) {
                unusable = e.getMessage();
            }
            endSingle(bytes);
            waiting.changes().raise();
        }

        @Override
        public void lost() {
            newest.lost();
            waiting.changes().raise();
        }
    }
}
