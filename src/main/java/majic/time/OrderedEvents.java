package majic.time;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/** Events that are delivered in the order they were put, by one thread at a time and with no lock held. Thread-safe. */
public final class OrderedEvents {
    private final Deque<Runnable> undelivered = new ArrayDeque<>();
    private @Nullable Thread delivering;
    private long put;
    private long delivered;

    /**
     * Appends an event; delivers nothing.
     *
     * @param event its delivery
     * @return its number, for {@link #isDelivered}
     */
    public synchronized long put(Runnable event) {
        undelivered.add(event);
        return ++put;
    }

    /**
     * Delivers on this thread all that is undelivered. Returns at once while another thread delivers: that goes on with
     * it.
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
     * Returns whether everything that was put has been delivered or is being delivered.
     *
     * @return false while an event waits
     */
    public synchronized boolean isEmpty() {
        return undelivered.isEmpty();
    }

    /** Whether there is something to deliver that no thread delivers already. */
    public synchronized boolean areDue() {
        return delivering == null && !undelivered.isEmpty();
    }

    /** Whether an event was delivered, or is to be by this very thread as soon as the present one has been. */
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

    /** The next event; without one this thread delivers no more, under the same lock that {@link #put} takes. */
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
