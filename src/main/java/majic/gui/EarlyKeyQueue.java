package majic.gui;

import java.awt.AWTEvent;
import java.awt.ActiveEvent;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.InvocationEvent;
import java.awt.event.KeyEvent;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/**
 * An event queue that passes on pressed keys while the event dispatch thread handles an earlier event. A thread of its
 * own looks for keys every few milliseconds while that thread is busy. All events are dispatched afterwards as without
 * it, in the same order.
 */
final class EarlyKeyQueue extends EventQueue {
    private static final Logger LOG = LateLogger.of(EarlyKeyQueue.class);
    private static final long LOOK_NANOS = 4_000_000;

    private final List<Consumer<KeyEvent>> listeners = new CopyOnWriteArrayList<>();
    private final Thread looking = new Thread(this::lookAlways, "early keys");
    private final Object taking = new Object();
    private final Fetches fetches = new Fetches();

    /**
     * Events that were taken from the queue in search of keys; dispatched before those in the queue. Guarded by taking.
     */
    private final Queue<AWTEvent> ahead = new ArrayDeque<>();

    private volatile boolean handling;
    private volatile boolean parked;

    private EarlyKeyQueue() {
        looking.setDaemon(true);
    }

    /**
     * Returns the queue of this program, and puts it in the place of the former one if necessary; it then stays there.
     * Must be called on the event dispatch thread.
     */
    static EarlyKeyQueue installed() {
        EventQueue present = Toolkit.getDefaultToolkit().getSystemEventQueue();
        if (present instanceof EarlyKeyQueue queue) {
            return queue;
        }
        EarlyKeyQueue queue = new EarlyKeyQueue();
        present.push(queue);
        empty(present);
        queue.looking.start();
        return queue;
    }

    /** Takes the event out of a replaced queue by which Java wakes the event dispatch thread if that waits there. */
    private static void empty(EventQueue replaced) {
        try {
            while (replaced.peekEvent() != null) {
                replaced.getNextEvent();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Adds a listener to pressed keys. It is called on the thread "early keys", once for each key that was pressed
     * while an event was being handled; a key that was pressed at another time is dispatched at once.
     *
     * @param listener receives the event that is dispatched later
     */
    void addListener(Consumer<KeyEvent> listener) {
        listeners.add(listener);
        LockSupport.unpark(looking);
    }

    void removeListener(Consumer<KeyEvent> listener) {
        listeners.remove(listener);
    }

    /** Called when another queue takes the place of this one, which then gets all events. */
    @Override
    public void push(EventQueue next) {
        synchronized (taking) {
            super.push(next);
            ahead.forEach(next::postEvent);
            ahead.clear();
        }
    }

    @Override
    public AWTEvent getNextEvent() throws InterruptedException {
        AWTEvent next;
        synchronized (taking) {
            handling = false;
            next = ahead.poll();
        }
        if (next == null) {
            next = super.getNextEvent();
        }
        handling = true;
        if (parked && !listeners.isEmpty()) {
            LockSupport.unpark(looking);
        }
        return next;
    }

    private void lookAlways() {
        while (true) {
            parked = true;
            while (!handling || listeners.isEmpty()) {
                LockSupport.park(this);
            }
            parked = false;
            LockSupport.parkNanos(this, LOOK_NANOS);
            look().forEach(key -> listeners.forEach(listener -> pass(key, listener)));
        }
    }

    private static void pass(KeyEvent key, Consumer<KeyEvent> listener) {
        try {
            listener.accept(key);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "a listener to early keys failed", e);
        }
    }

    /** Returns the keys that have been pressed while the present event is being handled, each only once. */
    private List<KeyEvent> look() {
        synchronized (taking) {
            return handling ? keysBehindPresentEvent() : List.of();
        }
    }

    /** Takes the events only if there is a key among them. */
    private List<KeyEvent> keysBehindPresentEvent() {
        postEvent(new Fetch(fetches));
        return peekEvent(KeyEvent.KEY_PRESSED) == null ? List.of() : keysOfTakenEvents();
    }

    private List<KeyEvent> keysOfTakenEvents() {
        InvocationEvent last = new InvocationEvent(this, () -> {});
        postEvent(last);
        List<KeyEvent> keys = new ArrayList<>();
        for (AWTEvent event = taken(); event != null && event != last; event = taken()) {
            ahead.add(event);
            if (event instanceof KeyEvent key && key.getID() == KeyEvent.KEY_PRESSED) {
                keys.add(key);
            }
        }
        return keys;
    }

    private @Nullable AWTEvent taken() {
        try {
            return peekEvent() == null ? null : super.getNextEvent();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return null;
        }
    }

    /** An event without effect. Posting it fetches what the window system has sent. */
    private static final class Fetch extends AWTEvent implements ActiveEvent {
        private static final long serialVersionUID = 1L;

        Fetch(Fetches source) {
            super(source, RESERVED_ID_MAX + 1);
        }

        @Override
        public void dispatch() {}
    }

    /** Lets the queue keep only one of the events without effect, however long the present event takes. */
    private static final class Fetches extends Component {
        private static final long serialVersionUID = 1L;

        @Override
        protected AWTEvent coalesceEvents(AWTEvent waiting, AWTEvent posted) {
            return waiting;
        }
    }
}
