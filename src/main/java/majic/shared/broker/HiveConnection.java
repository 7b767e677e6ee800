package majic.shared.broker;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** A connection by the HiveMQ client: a {@link HiveSession}, and after its loss the next one. */
final class HiveConnection implements BrokerConnection {
    private static final long ACKNOWLEDGE_MS = 2_000;
    private static final long CLOSE_MS = 500;
    private static final int SHORTEST_PAUSE_MS = 500;
    private static final int LONGEST_PAUSE_MS = 1_500;

    /** After sessions that end because of what the broker sends, since it may send that again at once. */
    private static final int LONGEST_PAUSE_AFTER_MALFORMED_MS = 30_000;

    private final BrokerAddress address;
    private final ConnectOptions options;
    private final ThreadPoolExecutor handlers;
    private final TopicHandlers urgent = new TopicHandlers();
    private final TopicHandlers subscriptions = new TopicHandlers();
    private final List<Watcher> watchers = new CopyOnWriteArrayList<>();
    private final CountDownLatch end = new CountDownLatch(1);
    private @Nullable HiveSession session;
    private int longestPauseMs = LONGEST_PAUSE_MS;
    private boolean begun;
    private boolean closed;

    HiveConnection(BrokerAddress address, ConnectOptions options) {
        this.address = address;
        this.options = options;
        handlers = HiveThreads.handlers(address);
    }

    @Override
    public void connect() {
        synchronized (this) {
            requireNotClosed();
            if (begun) {
                return;
            }
            begun = true;
        }
        try {
            openSession();
        } catch (BotException e) {
            synchronized (this) {
                begun = false;
            }
            throw e;
        }
    }

    private void requireNotClosed() {
        if (closed) {
            throw new BotException("the connection to " + address + " is closed");
        }
    }

    /** Opens a session, makes the subscriptions, and reports the connection before the first message is handled. */
    private void openSession() {
        CountDownLatch ready = new CountDownLatch(1);
        handlers.execute(() -> awaitQuietly(ready));
        try {
            HiveSession[] opened = new HiveSession[1];
            opened[0] = HiveSession.open(address, options, handlers, new Handlers(), cause -> lost(opened[0], cause));
            begin(opened[0]);
        } finally {
            ready.countDown();
        }
    }

    private void begin(HiveSession opened) {
        synchronized (this) {
            if (closed) {
                opened.disconnect();
                throw new BotException("closed while connecting");
            }
            session = opened;
            Stream.of(urgent, subscriptions).forEach(kind -> kind.all().forEach(one -> subscribe(opened, one)));
        }
        notify(Watcher::connected);
        if (!opened.isOpen()) {
            lost(opened, new TimeoutException("Timeout"));
        }
    }

    private void subscribe(HiveSession opened, TopicHandlers.Subscription one) {
        opened.subscribe(one.filter(), one.quality()).whenComplete((done, failure) -> {
            if (failure != null) {
                HiveErrors.notSubscribed(failure)
                        .ifPresent(reason -> notify(watcher -> watcher.notSubscribed(one.filter(), reason)));
            }
        });
    }

    private void notify(Consumer<Watcher> event) {
        List<Watcher> present = List.copyOf(watchers);
        handlers.execute(() -> present.forEach(
                watcher -> TopicHandlers.guarded("reporting a connection", () -> event.accept(watcher))));
    }

    private void lost(@Nullable HiveSession ended, Throwable cause) {
        synchronized (this) {
            if (ended == null || session != ended || closed) {
                return;
            }
            session = null;
            longestPauseMs = HiveErrors.isMalformed(cause)
                    ? Math.min(2 * longestPauseMs, LONGEST_PAUSE_AFTER_MALFORMED_MS)
                    : LONGEST_PAUSE_MS;
        }
        String reason = HiveErrors.lost(cause);
        notify(watcher -> watcher.lost(reason));
        HiveThreads.start("MQTT reconnect " + address.hostAndPort(), this::reconnect);
    }

    /**
     * Tries until a session is open or the connection is closed. The pauses differ, so clients do not return at once.
     */
    private void reconnect() {
        try {
            while (!end.await(pauseMs(), TimeUnit.MILLISECONDS)) {
                if (reconnected()) {
                    return;
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized long pauseMs() {
        return ThreadLocalRandom.current()
                .nextInt(SHORTEST_PAUSE_MS * longestPauseMs / LONGEST_PAUSE_MS, longestPauseMs);
    }

    private boolean reconnected() {
        try {
            openSession();
            return true;
        } catch (BotException e) {
            return false;
        }
    }

    @Override
    public void watch(Watcher watcher) {
        synchronized (this) {
            watchers.add(watcher);
            if (session != null) {
                handlers.execute(() -> TopicHandlers.guarded("reporting a connection", watcher::connected));
            }
        }
    }

    @Override
    public void subscribe(String filter, Quality quality, Handler handler) {
        subscribe(subscriptions, filter, quality, handler);
    }

    @Override
    public void subscribeUrgently(String filter, Quality quality, Handler handler) {
        subscribe(urgent, filter, quality, handler);
    }

    private void subscribe(TopicHandlers kind, String filter, Quality quality, Handler handler) {
        TopicHandlers.Subscription added;
        CompletableFuture<?> acknowledged;
        synchronized (this) {
            requireNotClosed();
            added = kind.add(filter, quality, handler);
            if (session == null) {
                return;
            }
            acknowledged = session.subscribe(filter, quality);
        }
        try {
            acknowledged.get(ACKNOWLEDGE_MS, TimeUnit.MILLISECONDS);
        } catch (ExecutionException | TimeoutException e) {
            if (isConnected()) {
                kind.remove(added);
                throw new BotException(
                        address + ": the broker does not accept the subscription to " + filter
                                + HiveErrors.notSubscribed(e)
                                        .map(reason -> " (" + reason + ")")
                                        .orElse("")
                                + "; has this user the right to read there?",
                        e);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void unsubscribe(String filter) {
        HiveSession present;
        synchronized (this) {
            boolean wasUrgent = urgent.remove(filter);
            present = subscriptions.remove(filter) || wasUrgent ? session : null;
        }
        if (present != null) {
            present.unsubscribe(filter);
        }
    }

    @Override
    public void publish(BrokerMessage message) {
        publish(message, problem -> {
            if (problem instanceof PublicationRefused refused) {
                notify(watcher -> watcher.notPublished(message, refused.reason()));
            }
        });
    }

    @Override
    public void publish(BrokerMessage message, Consumer<@Nullable BotException> acknowledged) {
        HiveSession present = present();
        if (present == null || !present.isOpen()) {
            throw new BotException("not connected to the broker " + address.hostAndPort());
        }
        present.publish(
                message,
                failure -> acknowledged.accept(failure == null ? null : HiveErrors.notPublished(message, failure)));
    }

    private synchronized @Nullable HiveSession present() {
        return session;
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    @Override
    public boolean isConnected() {
        HiveSession present = present();
        return present != null && present.isOpen();
    }

    @Override
    public TimeSource time() {
        return options.environment().time();
    }

    @Override
    public void close() {
        HiveSession ended;
        synchronized (this) {
            closed = true;
            ended = session;
            session = null;
        }
        end.countDown();
        if (ended != null) {
            disconnect(ended);
        }
        handlers.shutdownNow();
    }

    /** Passes messages to the handlers. */
    private final class Handlers implements HiveSession.Arrivals {
        @Override
        public boolean hasHandler(String topic, boolean isUrgent) {
            return (isUrgent ? urgent : subscriptions).hasHandler(topic);
        }

        @Override
        public void received(BrokerMessage message, boolean isUrgent) {
            if (!isClosed()) {
                (isUrgent ? urgent : subscriptions).dispatch(message);
            }
        }

        @Override
        public void malformed(String topic, String problem) {
            HiveConnection.this.notify(watcher -> watcher.malformed(topic, problem));
        }
    }

    private static void disconnect(HiveSession ended) {
        try {
            ended.disconnect().get(CLOSE_MS, TimeUnit.MILLISECONDS);
        } catch (ExecutionException | TimeoutException e) {
            // The connection ends with the process at the latest, and the broker notices it by the keep alive.
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void awaitQuietly(CountDownLatch ready) {
        try {
            ready.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
