package majic.ros;

import com.fasterxml.jackson.databind.JsonNode;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.RosSubscription;
import majic.ros.bridge.TopicActivity;
import majic.ros.bridge.TopicSubscription;
import majic.ros.readings.TopicSource;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A connection beside the one that drives the robot. Opened by the first subscription, opened again after its loss,
 * closed when nothing has been subscribed to for some seconds. Everything is sent on a thread of its own, so that a
 * connection that takes nothing blocks no caller. Thread-safe.
 */
final class SideConnection implements TopicSource {
    private static final Logger LOG = System.getLogger(SideConnection.class.getName());

    /** From one ping to the next, seconds. */
    private static final double CHECK_S = 1;

    /** The connection is given up when nothing has arrived for so long, seconds. */
    private static final double SILENCE_S = 4;

    private static final double RETRY_S = 2;
    private static final double IDLE_S = 10;

    private final String name;
    private final TimeSource time;
    private final Opener opener;
    private final Signal changes;
    private final List<Wish> wishes = new CopyOnWriteArrayList<>();
    private volatile @Nullable RosBridge bridge;
    private volatile boolean changed;
    private volatile boolean closed;
    private boolean started;
    private boolean noticed;
    private long triedNanos;
    private long neededNanos;

    /** Opens connections with the server. */
    interface Opener {
        /**
         * Opens one; throws BotException if the server does not accept it.
         *
         * @param lost called on the reader thread at its end
         */
        RosBridge open(Runnable lost);

        /** Sends a notice to the user. */
        void notice(String message);
    }

    /**
     * A connection that is not open.
     *
     * @param name of its thread
     */
    SideConnection(String name, TimeSource time, Opener opener) {
        this.name = name;
        this.time = time;
        this.opener = opener;
        this.changes = time.signal();
        this.triedNanos = time.nanos() - (long) (RETRY_S * 1e9);
    }

    @Override
    public Runnable subscribe(TopicSubscription wanted, Receiver receiver) {
        if (closed) {
            throw new LinkLost("not connected");
        }
        Wish wish = new Wish(wanted, receiver);
        wishes.add(wish);
        start();
        change();
        return () -> {
            wish.ended = true;
            change();
        };
    }

    private synchronized void start() {
        if (!started && !closed) {
            started = true;
            time.thread(name, this::run).start();
        }
    }

    private void change() {
        changed = true;
        changes.raise();
    }

    @Override
    public Arriving arriving() {
        RosBridge open = bridge;
        return open == null ? Arriving.NOTHING : open.arriving();
    }

    @Override
    public double roundTripS() {
        RosBridge open = bridge;
        return open == null ? 0 : open.roundTripS();
    }

    /** Returns the topics that are subscribed to now, in no order. */
    List<TopicActivity> activity() {
        RosBridge open = bridge;
        return open == null ? List.of() : open.activity();
    }

    private void run() {
        try {
            while (!closed) {
                changed = false;
                serve();
                changes.await(() -> closed || changed, CHECK_S);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void serve() {
        if (!wishes.isEmpty()) {
            neededNanos = time.nanos();
        }
        RosBridge open = bridge;
        if (open == null && !wishes.isEmpty() && time.secondsSince(triedNanos) >= RETRY_S) {
            open = opened();
        }
        if (open != null) {
            use(open);
        }
    }

    private @Nullable RosBridge opened() {
        triedNanos = time.nanos();
        try {
            RosBridge opened = opener.open(this::lost);
            bridge = opened;
            if (!opened.isOpen()) {
                lost();
            }
            return bridge;
        } catch (BotException e) {
            if (!noticed && !closed) {
                noticed = true;
                opener.notice("what needs a further connection to the rosbridge server is not read, because "
                        + e.getMessage());
            }
            return null;
        }
    }

    private void use(RosBridge open) {
        if (open.silenceS() > SILENCE_S) {
            open.abort();
            return;
        }
        try {
            wishes.forEach(wish -> wish.send(open));
            open.ping();
            if (open.arriving().bytes() == 0) {
                open.renewSilentSubscriptions();
            }
            if (time.secondsSince(neededNanos) > IDLE_S) {
                bridge = null;
                open.close();
            }
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "the connection has ended, which its reader thread reports", e);
        }
    }

    /** Called on the reader thread. */
    private void lost() {
        RosBridge ended = bridge;
        if (ended != null && !ended.isOpen()) {
            bridge = null;
            wishes.forEach(wish -> wish.receiver.lost());
            change();
        }
    }

    /** Ends the connection in order, and for good. */
    void close(double seconds) {
        RosBridge open = end();
        if (open != null) {
            open.close(seconds);
        }
    }

    /** Cuts the connection, for good. */
    void abort() {
        RosBridge open = end();
        if (open != null) {
            open.abort();
        }
    }

    private synchronized @Nullable RosBridge end() {
        closed = true;
        changes.raise();
        return bridge;
    }

    /** A subscription that is wanted, whether or not there is a connection. */
    private final class Wish {
        final TopicSubscription wanted;
        final Receiver receiver;
        volatile boolean ended;
        private @Nullable RosBridge on;
        private @Nullable RosSubscription subscription;

        Wish(TopicSubscription wanted, Receiver receiver) {
            this.wanted = wanted;
            this.receiver = receiver;
        }

        /** Subscribes on a connection, once, or unsubscribes. */
        void send(RosBridge open) {
            if (ended) {
                wishes.remove(this);
                if (on == open && subscription != null) {
                    subscription.close();
                }
            } else if (on != open) {
                on = open;
                subscription = open.subscribeSized(wanted, this::arrived);
            }
        }

        private void arrived(JsonNode message, int bytes) {
            if (!ended) {
                receiver.message(message, bytes);
            }
        }
    }
}
