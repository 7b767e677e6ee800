package majic.shared.broker;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import majic.time.TimeSource;

/**
 * An MQTT 5 broker in memory on a test's clock: retained messages with their expiry, wills, filters, and connections
 * that a test can cut, hold back, deliver at once and kill. It keeps nothing for clients that are not connected.
 * Thread-safe.
 */
public final class FakeBroker implements AutoCloseable {
    private final TimeSource time;
    private final List<FakeConnection> connections = new ArrayList<>();
    private final Map<String, Retained> retained = new TreeMap<>();
    private final Map<String, Integer> leftOut = new HashMap<>();
    private final List<BrokerMessage> published = new ArrayList<>();
    private boolean running = true;
    private boolean repeating;

    /** A message that was kept, and when. */
    private record Retained(BrokerMessage message, long sinceNanos) {}

    /**
     * Creates a running broker without messages.
     *
     * @param time a stepped clock, or the system's
     */
    public FakeBroker(TimeSource time) {
        this.time = time;
    }

    /** Creates a connection, which is not made yet. */
    public FakeConnection open(ConnectOptions options) {
        return new FakeConnection(this, options);
    }

    /** Ends the broker as a crash does: all connections are lost, and no will is published. */
    public synchronized void stop() {
        running = false;
        new ArrayList<>(connections).forEach(connection -> connection.lose("the broker closed the connection", false));
    }

    /** Starts the broker again, with the retained messages it had. */
    public synchronized void start() {
        running = true;
    }

    /** From now on every message with quality of service 1 arrives twice. */
    public synchronized void repeat() {
        repeating = true;
    }

    /** Forgets all retained messages, as a broker without a store does when it is started again. */
    public synchronized void forget() {
        retained.clear();
    }

    /** Publishes a message as a client that is not of this program. */
    public synchronized void publish(BrokerMessage message) {
        published.add(message);
        if (message.retained()) {
            keep(message);
        }
        new ArrayList<>(connections).forEach(connection -> deliver(connection, message.withRetained(false)));
    }

    /** Delivers a malformed message to the connections that have subscribed to its topic. */
    public synchronized void publishMalformed(String topic, String problem) {
        new ArrayList<>(connections)
                .stream()
                        .filter(connection -> connection.subscribed(topic).isPresent())
                        .forEach(connection -> connection.arriveMalformed(topic, problem));
    }

    /** All messages that were published and match a filter, the oldest first. */
    public synchronized List<BrokerMessage> published(String filter) {
        TopicFilter topics = new TopicFilter(filter);
        return published.stream()
                .filter(message -> topics.matches(message.topic()))
                .toList();
    }

    /** The message that is kept for later subscribers of a topic. */
    public synchronized Optional<BrokerMessage> retained(String topic) {
        return Optional.ofNullable(retained.get(topic))
                .filter(kept -> !isExpired(kept))
                .map(Retained::message);
    }

    /** All kept messages that match a filter, ordered by topic. */
    public synchronized List<BrokerMessage> allRetained(String filter) {
        TopicFilter topics = new TopicFilter(filter);
        return retained.values().stream()
                .filter(kept -> !isExpired(kept) && topics.matches(kept.message.topic()))
                .map(Retained::message)
                .toList();
    }

    /** The clock that the broker was made with. */
    public TimeSource time() {
        return time;
    }

    private void keep(BrokerMessage message) {
        if (message.payload().length == 0) {
            retained.remove(message.topic());
        } else {
            retained.put(message.topic(), new Retained(message, time.nanos()));
        }
    }

    private boolean isExpired(Retained kept) {
        int seconds = kept.message.expirySeconds();
        return seconds > 0 && time.nanos() - kept.sinceNanos >= TimeUnit.SECONDS.toNanos(seconds);
    }

    private void deliver(FakeConnection to, BrokerMessage message) {
        Optional<Quality> quality = to.subscribed(message.topic());
        if (quality.isEmpty()) {
            return;
        }
        boolean once = quality.get() == Quality.AT_MOST_ONCE || message.quality() == Quality.AT_MOST_ONCE;
        to.arrive(message);
        if (repeating && !once) {
            to.arrive(message);
        }
    }

    /** Accepts a client; one of the same name loses its connection. */
    synchronized boolean accept(FakeConnection client) {
        if (!running) {
            return false;
        }
        new ArrayList<>(connections)
                .stream()
                        .filter(other -> other != client && other.clientId().equals(client.clientId()))
                        .forEach(other -> other.lose("another program connected under the same name", true));
        connections.add(client);
        return true;
    }

    /** Forgets a client; publishes its will unless it has disconnected. */
    synchronized void remove(FakeConnection client, boolean withWill) {
        if (connections.remove(client) && withWill && client.will() != null) {
            publish(client.will());
        }
    }

    /** Delivers what is kept for a new subscription. */
    synchronized void deliverRetained(FakeConnection to, String filter) {
        allRetained(filter).stream()
                .filter(message -> !isLeftOut(message.topic()))
                .forEach(message -> to.arrive(message.withRetained(true)));
    }

    private boolean isLeftOut(String topic) {
        int times = leftOut.getOrDefault(topic, 0);
        leftOut.put(topic, times - 1);
        return times > 0;
    }

    /** Leaves a kept message out for some subscriptions, as a broker does whose queue is full. */
    public synchronized void leaveOut(String topic, int times) {
        leftOut.put(topic, times);
    }

    @Override
    public synchronized void close() {
        new ArrayList<>(connections).forEach(FakeConnection::close);
    }
}
