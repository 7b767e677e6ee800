package majic.shared;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.MessageLimit;
import majic.shared.broker.Quality;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.time.Signal;
import majic.time.WaitPolicy;

/**
 * The connection to one broker that all shared robots behind it use: several handlers for one topic, requests and their
 * answers. Thread-safe.
 */
final class PooledBroker implements BrokerConnection.Watcher {
    private static final Logger LOG = System.getLogger(PooledBroker.class.getName());

    /** More lines of one desk cannot be read while they appear. */
    private static final int LINES_PER_S = 20;

    private final BrokerConnection connection;
    private final Sender sender;
    private final String sessionHash;
    private final Map<String, List<BrokerConnection.Handler>> handlers = new ConcurrentHashMap<>();
    private final Map<String, PendingReply> pending = new ConcurrentHashMap<>();
    private final Set<String> sitesWithReplies = ConcurrentHashMap.newKeySet();
    private final List<Consumer<String>> lossListeners = new CopyOnWriteArrayList<>();
    private final Map<String, MessageLimit> lines = new ConcurrentHashMap<>();
    private final AtomicLong requests;
    private final Signal changes;

    /**
     * Uses a connection.
     *
     * @param sender the sender of the requests
     * @param requests counts the requests of the session, over all brokers
     */
    PooledBroker(BrokerConnection connection, Sender sender, AtomicLong requests) {
        this.connection = connection;
        this.sender = sender;
        this.sessionHash = sender.sessionHash();
        this.requests = requests;
        this.changes = connection.time().signal();
        connection.watch(this);
    }

    /**
     * Opens the connection, or waits until it is made again.
     *
     * @param seconds the longest wait for that
     * @return whether there is a connection
     * @throws BotException if the broker cannot be reached
     */
    boolean connect(double seconds) {
        connection.connect();
        return new RobotWait(connection.time(), changes).awaitConnecting(connection::isConnected, seconds);
    }

    BrokerConnection connection() {
        return connection;
    }

    Sender sender() {
        return sender;
    }

    /** Returns what others see in place of the session of the sender. */
    String sessionHash() {
        return sessionHash;
    }

    /** Returns the limit of the lines that are shown of one desk, for all of its robots together. */
    MessageLimit lines(SharedAddress robot) {
        return lines.computeIfAbsent(
                robot.broker().site() + "/" + robot.desk(), key -> new MessageLimit(connection.time(), LINES_PER_S));
    }

    /** Returns the number for another request. */
    long nextNumber() {
        return requests.incrementAndGet();
    }

    /** Returns the number of the last request. */
    long lastNumber() {
        return requests.get();
    }

    /**
     * Adds a handler for a topic or filter. It gets the retained messages; handlers of the same topic get them once
     * more.
     *
     * @throws BotException if the broker refuses
     */
    void subscribe(String filter, Quality quality, BrokerConnection.Handler handler) {
        handlers.computeIfAbsent(filter, key -> new CopyOnWriteArrayList<>()).add(handler);
        try {
            connection.subscribe(filter, quality, message -> dispatch(filter, message));
        } catch (RuntimeException e) {
            unsubscribe(filter, handler);
            throw e;
        }
    }

    /** Removes a handler, and the subscription with the last one. */
    void unsubscribe(String filter, BrokerConnection.Handler handler) {
        handlers.computeIfPresent(filter, (key, present) -> {
            present.remove(handler);
            if (!present.isEmpty()) {
                return present;
            }
            connection.unsubscribe(filter);
            return null;
        });
    }

    private void dispatch(String filter, BrokerMessage message) {
        for (BrokerConnection.Handler handler : handlers.getOrDefault(filter, List.of())) {
            guarded(() -> handler.received(message));
        }
    }

    /** One robot's mistake must not keep the message from the others. */
    private static void guarded(Runnable task) {
        try {
            WaitPolicy.without(task);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a message of a broker was not handled", e);
        }
    }

    /**
     * Subscribes to the answers of a site, unless that was done before.
     *
     * @throws BotException if the broker refuses
     */
    void expectReplies(SiteTopics topics) {
        if (sitesWithReplies.add(topics.site())) {
            try {
                subscribe(topics.replies(sessionHash), Quality.AT_LEAST_ONCE, this::replied);
            } catch (RuntimeException e) {
                sitesWithReplies.remove(topics.site());
                throw e;
            }
        }
    }

    private void replied(BrokerMessage message) {
        byte[] correlation = message.correlation();
        if (correlation != null) {
            PendingReply one = pending.get(new String(correlation, StandardCharsets.UTF_8));
            if (one != null) {
                one.received(message);
            }
        }
    }

    /** Expects answers with a correlation, until {@link #forget}. */
    PendingReply expect(String correlation, RobotWait waiting) {
        PendingReply reply = new PendingReply(correlation, waiting);
        pending.put(correlation, reply);
        return reply;
    }

    /**
     * Publishes a message that asks for an answer.
     *
     * @param message without response topic
     * @param topics of the site, whose answers are expected
     * @param reply takes the answer; a refusal of the broker, too
     * @throws BotException while there is no connection; nothing was sent
     */
    void publish(BrokerMessage message, SiteTopics topics, PendingReply reply) {
        connection.publish(message.answeredAt(topics.replies(sessionHash), reply.correlationData()), problem -> {
            if (problem != null) {
                reply.refused(String.valueOf(problem.getMessage()));
            }
        });
    }

    /** Expects no further answer. */
    void forget(PendingReply reply) {
        pending.remove(reply.correlation(), reply);
    }

    /** Adds a listener for the loss of the connection, called with the reason. */
    void addLossListener(Consumer<String> listener) {
        lossListeners.add(listener);
    }

    /** Removes a listener. */
    void removeLossListener(Consumer<String> listener) {
        lossListeners.remove(listener);
    }

    @Override
    public void connected() {
        changes.raise();
    }

    @Override
    public void lost(String reason) {
        lossListeners.forEach(listener -> guarded(() -> listener.accept(reason)));
    }
}
