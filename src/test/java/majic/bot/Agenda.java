package majic.bot;

import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.Queue;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * What a scripted peer is going to do, in the order of time, on a thread that lives by its clock. Safe from any thread.
 */
public final class Agenda implements AutoCloseable {
    private final TimeSource time;
    private final Signal changes;
    private final Queue<Event> events =
            new PriorityQueue<>(Comparator.<Event>comparingLong(e -> e.atNanos).thenComparingLong(e -> e.number));
    private long numbers;
    private boolean closed;

    /** Something that is going to happen, once or again and again. Guarded by its agenda. */
    public final class Event {
        private final Runnable action;
        private final long periodNanos;
        private long atNanos;
        private long number;
        private boolean over;

        private Event(Runnable action, long periodNanos) {
            this.action = action;
            this.periodNanos = periodNanos;
        }

        /** Whether it has happened for the last time, or was cancelled. */
        public boolean isOver() {
            synchronized (Agenda.this) {
                return over;
            }
        }

        /** Keeps it from happening (again); false if it was too late for that. */
        public boolean cancel() {
            synchronized (Agenda.this) {
                boolean inTime = !over;
                over = true;
                events.remove(this);
                return inTime;
            }
        }
    }

    public Agenda(TimeSource time) {
        this.time = time;
        this.changes = time.signal();
        time.thread("agenda", this::run).start();
    }

    /** Does something once. */
    public Event after(long delayMs, Runnable action) {
        return add(new Event(action, 0), time.nanos() + delayMs * 1_000_000);
    }

    /** Does something at once and then again and again. */
    public Event every(long periodMs, Runnable action) {
        return add(new Event(action, periodMs * 1_000_000), time.nanos());
    }

    private Event add(Event event, long atNanos) {
        synchronized (this) {
            event.atNanos = atNanos;
            event.number = numbers++;
            events.add(event);
        }
        changes.raise();
        return event;
    }

    private void run() {
        try {
            while (!isClosed()) {
                long seen = numbers();
                Event due = takeDue();
                if (due == null) {
                    changes.await(() -> isClosed() || numbers() != seen, secondsToNext());
                } else {
                    due.action.run();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized @Nullable Event takeDue() {
        Event next = events.peek();
        if (next == null || next.atNanos > time.nanos()) {
            return null;
        }
        events.remove();
        if (next.periodNanos > 0) {
            next.atNanos += next.periodNanos;
            next.number = numbers++;
            events.add(next);
        } else {
            next.over = true;
        }
        return next;
    }

    private synchronized double secondsToNext() {
        Event next = events.peek();
        return next == null ? Signal.FOR_EVER : (next.atNanos - time.nanos()) / 1e9;
    }

    private synchronized long numbers() {
        return numbers;
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    /** Drops what has not happened yet. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            events.clear();
        }
        changes.raise();
    }
}
