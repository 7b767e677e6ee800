package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.time.OrderedEvents;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;

/**
 * The listeners of one robot; one that fails does not keep the others from being called. Events are delivered in their
 * order. A thread that must not wait, such as a reader or one that holds a command lock, passes its events to a
 * separate thread, so a listener that blocks delays no byte to or from the robot. Notices given while there is no
 * listener, as during connecting, are kept for the first. Thread-safe.
 */
final class Listeners {
    private static final Logger LOG = System.getLogger(Listeners.class.getName());
    private static final int MOST_KEPT = 10;

    /**
     * How long a thread that may wait gives another one to deliver its notice, seconds; longer only if a listener
     * blocks.
     */
    private static final double NOTICE_S = 0.1;

    /** The same for a change of the connection, which occurs rarely, seconds. */
    private static final double CHANGE_S = 1;

    private final MajicBot bot;
    private final List<BotListener> all = new CopyOnWriteArrayList<>();
    private final List<ScanListener> scanListeners = new CopyOnWriteArrayList<>();
    private final Map<String, RangeScan> undeliveredScans = new LinkedHashMap<>();
    private final Deque<String> undelivered = new ArrayDeque<>();
    private final OrderedEvents events = new OrderedEvents();
    private final AtomicBoolean statePending = new AtomicBoolean();
    private final Signal changed;
    private volatile boolean closed;

    Listeners(MajicBot bot, TimeSource time) {
        this.bot = bot;
        this.changed = time.signal();
    }

    /** Starts the thread that delivers what others must not wait for. It ends after {@link #close()}. */
    void start(TimeSource time, String name) {
        time.thread(name + " listeners", () -> WaitPolicy.without(this::run)).start();
    }

    private void run() {
        try {
            while (!isOver()) {
                changed.await(() -> isOver() || events.areDue(), Signal.FOR_EVER);
                events.deliver();
                changed.raise();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean isOver() {
        return closed && events.isEmpty();
    }

    /** Lets the thread end once all has been delivered. */
    void close() {
        closed = true;
        changed.raise();
    }

    void add(BotListener listener) {
        List<String> kept;
        synchronized (undelivered) {
            all.add(listener);
            kept = List.copyOf(undelivered);
            undelivered.clear();
        }
        kept.forEach(message -> call(listener, to -> to.notice(bot, message)));
    }

    void remove(BotListener listener) {
        all.remove(listener);
    }

    /** Delivers a notice from the robot to the user. */
    void notice(String message) {
        synchronized (undelivered) {
            if (all.isEmpty()) {
                keep(message);
                return;
            }
        }
        put(listener -> listener.notice(bot, message));
        deliverWithin(NOTICE_S);
    }

    private void keep(String message) {
        if (undelivered.size() == MOST_KEPT) {
            undelivered.removeFirst();
        }
        undelivered.addLast(message);
    }

    /**
     * New readings: of several that come faster than the listeners take them, they get the newest. Wakes no thread if
     * all listeners ignore them: that would take as long as decoding them.
     */
    void stateChanged() {
        if (!areStatesRead()) {
            return;
        }
        if (statePending.compareAndSet(false, true)) {
            events.put(this::deliverState);
        }
        pass();
    }

    private void deliverState() {
        statePending.set(false);
        BotState newest = bot.state();
        for (BotListener listener : all) {
            if (readsStates(listener)) {
                call(listener, to -> to.stateChanged(bot, newest));
            }
        }
    }

    private boolean areStatesRead() {
        for (BotListener listener : all) {
            if (readsStates(listener)) {
                return true;
            }
        }
        return false;
    }

    private static boolean readsStates(BotListener listener) {
        return !(listener instanceof EventOnlyListener);
    }

    /** Runs a task behind what was put before, on a thread that may deliver. */
    void afterwards(Runnable task) {
        events.put(() -> call(task));
        pass();
    }

    /** Delivers a picture of the camera. */
    void pictureTaken(Supplier<byte[]> jpeg) {
        put(listener -> listener.pictureTaken(bot, jpeg));
        pass();
    }

    void addScanListener(ScanListener listener) {
        scanListeners.add(listener);
    }

    void removeScanListener(ScanListener listener) {
        scanListeners.remove(listener);
    }

    boolean hasScanListeners() {
        return !scanListeners.isEmpty();
    }

    /** A scan: of several of one sensor that come faster than the listeners take them, they get the newest. */
    void scanned(RangeScan scan) {
        if (scanListeners.isEmpty()) {
            return;
        }
        synchronized (undeliveredScans) {
            if (undeliveredScans.put(scan.sensor().name(), scan) != null) {
                return;
            }
        }
        events.put(() -> deliverScan(scan.sensor().name()));
        pass();
    }

    private void deliverScan(String sensor) {
        RangeScan newest;
        synchronized (undeliveredScans) {
            newest = undeliveredScans.remove(sensor);
        }
        if (newest != null) {
            scanListeners.forEach(listener -> call(() -> listener.scanned(newest)));
        }
    }

    /** Queues a change of the connection state for delivery by {@link #deliver()}. */
    void connectionChanged(MajicBot.Connection now) {
        put(listener -> listener.connectionChanged(bot, now));
    }

    /** Queues an event for the listeners there are now: one that is added later has not seen what led to it. */
    private void put(Consumer<BotListener> event) {
        List<BotListener> present = List.copyOf(all);
        events.put(() -> present.stream().filter(all::contains).forEach(listener -> call(listener, event)));
    }

    /**
     * Delivers the queued changes of the connection. On a thread that may wait it returns after they have been
     * delivered, by whichever thread, or after {@link #CHANGE_S} while a listener blocks another thread.
     */
    void deliver() {
        deliverWithin(CHANGE_S);
    }

    /** Delivers what was put, so that it precedes this thread's next output, such as the answer to a command. */
    private void deliverWithin(double seconds) {
        long last = events.last();
        pass();
        if (!WaitPolicy.isAllowed()) {
            return;
        }
        try {
            changed.await(() -> events.isDelivered(last), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Delivers what was put: on this thread if it may wait and no other delivers, otherwise on the other one. */
    private void pass() {
        if (WaitPolicy.isAllowed()) {
            events.deliver();
        }
        changed.raise();
    }

    private void call(BotListener listener, Consumer<BotListener> news) {
        call(() -> news.accept(listener));
    }

    private void call(Runnable listener) {
        try {
            listener.run();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a listener of " + bot.name() + " failed", e);
        }
    }
}
