package majic.shared.broker;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A connection to a {@link FakeBroker}, with the faults of a network. All state is guarded by the broker. A lost
 * connection is made again 1 s later, and every second while the broker refuses it.
 */
public final class FakeConnection implements BrokerConnection {
    private static final double RETRY_SECONDS = 1;
    private static final double ACKNOWLEDGE_SECONDS = 2;

    private final FakeBroker broker;
    private final ConnectOptions options;
    private final TimeSource time;
    private final Signal changed;
    private final TopicHandlers subscriptions = new TopicHandlers();
    private final List<Watcher> watchers = new CopyOnWriteArrayList<>();
    private final Deque<Runnable> events = new ArrayDeque<>();
    private final List<Runnable> heldBack = new ArrayList<>();
    private boolean begun;
    private boolean connected;
    private boolean holding;
    private boolean unreachable;
    private volatile boolean closed;
    private volatile String refused = "";
    private long deadlineNanos = Long.MAX_VALUE;

    FakeConnection(FakeBroker broker, ConnectOptions options) {
        this.broker = broker;
        this.options = options;
        time = broker.time();
        changed = time.signal();
    }

    /** Cuts the cable: nothing passes; both ends notice after one and a half times the keep alive. */
    public void cut() {
        synchronized (broker) {
            unreachable = true;
            holding = true;
            deadlineNanos = after(1.5 * options.keepAliveSeconds());
        }
        changed.raise();
    }

    /** Plugs the cable in again. What was sent meanwhile arrives if neither end has noticed. */
    public void restore() {
        synchronized (broker) {
            unreachable = false;
            if (connected) {
                deadlineNanos = Long.MAX_VALUE;
            }
        }
        deliver();
    }

    /** Holds everything back in both directions, while the connection counts as alive. */
    public void holdBack() {
        synchronized (broker) {
            holding = true;
        }
    }

    /** Delivers at once what was held back, in its order. */
    public void deliver() {
        synchronized (broker) {
            holding = false;
            List<Runnable> all = List.copyOf(heldBack);
            heldBack.clear();
            all.forEach(Runnable::run);
        }
        changed.raise();
    }

    /** Ends the connection as a reset does: both ends notice at once. */
    public void drop() {
        lose("the connection was reset", true);
    }

    /** Ends the connection as a reset does; it cannot be made again before {@link #restore}. */
    public void unplug() {
        synchronized (broker) {
            unreachable = true;
        }
        drop();
    }

    /** Ends the program of the client as a crash does: its will is published, and it never does anything again. */
    public void kill() {
        synchronized (broker) {
            closed = true;
            connected = false;
            broker.remove(this, true);
        }
        changed.raise();
    }

    /** From now on the broker refuses what this client publishes on some topics; all again for an empty filter. */
    public void refuse(String filter) {
        refused = filter;
    }

    String clientId() {
        return options.clientId();
    }

    @Nullable
    BrokerMessage will() {
        return options.will();
    }

    /** The highest quality of service of the subscriptions for a topic; empty if there is none. */
    Optional<Quality> subscribed(String topic) {
        Optional<Quality> highest = Optional.empty();
        for (TopicHandlers.Subscription one : subscriptions.all()) {
            if (one.topics().matches(topic) && highest.orElse(Quality.AT_MOST_ONCE) == Quality.AT_MOST_ONCE) {
                highest = Optional.of(one.quality());
            }
        }
        return highest;
    }

    /** Takes a message from the broker. */
    void arrive(BrokerMessage message) {
        transport(() -> event(() -> subscriptions.dispatch(message)));
    }

    /** Takes a malformed message from the broker. */
    void arriveMalformed(String topic, String problem) {
        transport(() -> event(() -> watchers.forEach(watcher -> watcher.malformed(topic, problem))));
    }

    /** Ends the connection for both ends, unless it is closed. */
    void lose(String reason, boolean withWill) {
        synchronized (broker) {
            if (!connected) {
                return;
            }
            connected = false;
            heldBack.clear();
            deadlineNanos = after(RETRY_SECONDS);
            broker.remove(this, withWill);
            event(() -> watchers.forEach(watcher -> watcher.lost(reason)));
        }
    }

    private long after(double seconds) {
        return time.nanos() + (long) (seconds * 1e9);
    }

    private void event(Runnable event) {
        synchronized (broker) {
            events.add(event);
        }
        changed.raise();
    }

    /** Passes something over the network, or keeps it there. */
    private void transport(Runnable sent) {
        if (holding) {
            heldBack.add(sent);
        } else {
            sent.run();
        }
    }

    @Override
    public void connect() {
        synchronized (broker) {
            if (closed) {
                throw new BotException("the connection is closed");
            }
            if (begun) {
                return;
            }
            if (unreachable || !broker.accept(this)) {
                throw new ConnectFailed(Reason.REFUSED, "no broker answers; is it running?");
            }
            begun = true;
            established();
        }
        time.thread("fake connection " + clientId(), this::run).start();
    }

    private void established() {
        connected = true;
        holding = false;
        deadlineNanos = Long.MAX_VALUE;
        List<Watcher> present = List.copyOf(watchers);
        event(() -> present.forEach(Watcher::connected));
        subscriptions.all().forEach(one -> broker.deliverRetained(this, one.filter()));
    }

    private void run() {
        try {
            while (!closed) {
                long deadline = deadline();
                changed.await(() -> closed || hasEvent() || deadline() != deadline, secondsUntil(deadline));
                timeOut();
                for (Runnable event = nextEvent(); event != null; event = nextEvent()) {
                    TopicHandlers.guarded("handling an event of a connection", event);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean hasEvent() {
        synchronized (broker) {
            return !events.isEmpty() || deadlineNanos != Long.MAX_VALUE && deadlineNanos <= time.nanos();
        }
    }

    private long deadline() {
        synchronized (broker) {
            return deadlineNanos;
        }
    }

    private double secondsUntil(long deadline) {
        return deadline == Long.MAX_VALUE ? Signal.FOR_EVER : Math.max(0, (deadline - time.nanos()) / 1e9);
    }

    private @Nullable Runnable nextEvent() {
        synchronized (broker) {
            return closed ? null : events.poll();
        }
    }

    /** Notices a cut cable, or tries to connect again. */
    private void timeOut() {
        synchronized (broker) {
            if (closed || deadlineNanos > time.nanos()) {
                return;
            }
            if (connected) {
                lose("the broker does not answer", true);
            } else if (!unreachable && broker.accept(this)) {
                established();
            } else {
                deadlineNanos = after(RETRY_SECONDS);
            }
        }
    }

    @Override
    public void watch(Watcher watcher) {
        synchronized (broker) {
            watchers.add(watcher);
            if (connected) {
                event(watcher::connected);
            }
        }
    }

    @Override
    public void subscribe(String filter, Quality quality, Handler handler) {
        TopicHandlers.Subscription added = subscriptions.add(filter, quality, handler);
        if (!awaitPassage()) {
            subscriptions.remove(added);
            throw new BotException("the broker does not answer the subscription to " + filter);
        }
        synchronized (broker) {
            if (connected) {
                broker.deliverRetained(this, filter);
            }
        }
    }

    @Override
    public void subscribeUrgently(String filter, Quality quality, Handler handler) {
        subscribe(filter, quality, handler);
    }

    /** Waits until the network is not held back. */
    private boolean awaitPassage() {
        try {
            return changed.await(() -> !isHolding(), ACKNOWLEDGE_SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private boolean isHolding() {
        synchronized (broker) {
            return connected && holding;
        }
    }

    @Override
    public void unsubscribe(String filter) {
        subscriptions.remove(filter);
    }

    @Override
    public void publish(BrokerMessage message) {
        publish(message, problem -> {
            if (problem instanceof PublicationRefused refusal) {
                watchers.forEach(watcher -> watcher.notPublished(message, refusal.reason()));
            }
        });
    }

    @Override
    public void publish(BrokerMessage message, Consumer<@Nullable BotException> acknowledged) {
        synchronized (broker) {
            if (!connected) {
                throw new BotException("not connected to the broker");
            }
            transport(() -> {
                if (isRefused(message)) {
                    event(() -> acknowledged.accept(new PublicationRefused(message.topic(), "not authorized")));
                } else {
                    broker.publish(message);
                    event(() -> acknowledged.accept(null));
                }
            });
        }
    }

    private boolean isRefused(BrokerMessage message) {
        return !refused.isEmpty() && new TopicFilter(refused).matches(message.topic());
    }

    @Override
    public boolean isConnected() {
        synchronized (broker) {
            return connected;
        }
    }

    @Override
    public TimeSource time() {
        return time;
    }

    @Override
    public void close() {
        synchronized (broker) {
            closed = true;
            connected = false;
            broker.remove(this, false);
        }
        changed.raise();
    }
}
