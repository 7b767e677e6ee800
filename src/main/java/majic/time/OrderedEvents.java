package majic.time;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * Delivers events in the order in which they were added, by one thread at a time and with no lock held. Thread-safe.
 */
public final class OrderedEvents {
    private final Deque<Runnable> undelivered = new ArrayDeque<>();
    private @Nullable Thread delivering;
    private long put;
    private long delivered;

    /**
     * Appends an event; delivers nothing.
     *
     * @param event delivers it
     */
    public synchronized void put(Runnable event) {
        undelivered.add(event);
        put++;
    }

    /**
     * Returns the number of the event that was added last.
     *
     * @return for {@link #isDelivered}; 0 before the first
     */
    public synchronized long last() {
        return put;
    }

    /**
     * Delivers all undelivered events on this thread. Returns at once while another thread delivers, which then
     * delivers these too.
     */
    public void deliver() {
        if (!begin()) {
            return;
        }
        try {
            for (Runnable next = next(); next != null; next = next()) {
                next.run();
                count();
            }
        } finally {
            end();
        }
    }

    /**
     * Returns whether every event has been delivered or is being delivered.
     *
     * @return false while an event waits
     */
    public synchronized boolean isEmpty() {
        return undelivered.isEmpty();
    }

    /** Returns whether events wait while no thread delivers. */
    public synchronized boolean areDue() {
        return delivering == null && !undelivered.isEmpty();
    }

    /** Returns whether an event was delivered, or will be delivered by this thread after the present one. */
    public synchronized boolean isDelivered(long number) {
        return delivered >= number || delivering == Thread.currentThread();
    }

    private synchronized boolean begin() {
        if (delivering != null) {
            return false;
        }
        delivering = Thread.currentThread();
        return true;
    }

    /** Returns the next event; if there is none, ends the delivery under the same lock that {@link #put} takes. */
    private synchronized @Nullable Runnable next() {
        Runnable next = undelivered.poll();
        if (next == null) {
            delivering = null;
        }
        return next;
    }

    private synchronized void count() {
        delivered++;
    }

    private synchronized void end() {
        if (delivering == Thread.currentThread()) {
            delivering = null;
        }
    }
}
