package majic.link;

import java.io.IOException;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.Lock;

/**
 * Aborts a link whose write does not return in time, which wakes the writer. One thread monitors all writes; the abort,
 * which the driver of a serial port may block, runs on a thread of its own. The monitor runs by itself while there are
 * writes; waking it for each write would cost more than the write.
 *
 * <p>A write is aborted only if the monitor has found it in progress twice, with a pause in between. Otherwise, after a
 * time in which the whole program did not run, as on a suspended virtual machine, each write that was in progress would
 * end its connection before it could return.
 */
final class WriteDeadline implements AutoCloseable {
    private static final long DEADLINE_NANOS = TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS);

    /** From the first time a late write is found to the second. */
    static final long CONFIRM_NANOS = DEADLINE_NANOS / 4;

    private static final long FIRST_LOOK_NANOS = DEADLINE_NANOS - CONFIRM_NANOS;
    private static final ScheduledThreadPoolExecutor MONITOR =
            new ScheduledThreadPoolExecutor(1, body -> daemon(body, "link write deadlines"));
    private static final Set<WriteDeadline> IN_PROGRESS = ConcurrentHashMap.newKeySet();
    private static final AtomicBoolean MONITORED = new AtomicBoolean();
    private static volatile boolean begun;

    private final Link link;
    private long dueNanos;
    private boolean foundLate;
    private volatile boolean passed;

    /** Creates the deadline of a write that begins at a time of {@link System#nanoTime}; it is not monitored yet. */
    WriteDeadline(Link link, long nowNanos) {
        this.link = link;
        this.dueNanos = nowNanos + FIRST_LOOK_NANOS;
    }

    /** Writes one message. */
    interface Output {
        /**
         * Writes it, or throws why it cannot be written: a failed write ends the link.
         *
         * @throws IOException with the reason
         */
        void write() throws IOException;
    }

    /**
     * Writes a message within the deadline, the wait for other writers of the link included.
     *
     * @param writing held while a message is written
     * @param place the peer, as a message names it
     * @param output writes the message
     * @throws IOException if it cannot be written; the link was aborted
     */
    static void write(Link link, Lock writing, String place, Output output) throws IOException {
        try (WriteDeadline deadline = start(link)) {
            writing.lock();
            try {
                output.write();
            } catch (IOException e) {
                link.abort();
                throw deadline.passed() ? new IOException(place + " takes no more data", e) : e;
            } finally {
                writing.unlock();
            }
        }
    }

    static WriteDeadline start(Link link) {
        WriteDeadline deadline = new WriteDeadline(link, System.nanoTime());
        IN_PROGRESS.add(deadline);
        begun = true;
        startMonitor();
        return deadline;
    }

    boolean passed() {
        return passed;
    }

    @Override
    public void close() {
        IN_PROGRESS.remove(this);
    }

    private static void startMonitor() {
        if (!MONITORED.get() && MONITORED.compareAndSet(false, true)) {
            checkAfter(FIRST_LOOK_NANOS);
        }
    }

    private static void checkAfter(long nanos) {
        MONITOR.schedule(WriteDeadline::check, nanos, TimeUnit.NANOSECONDS);
    }

    /** Reschedules itself while writes are in progress or have begun since the last check. */
    private static void check() {
        boolean busy = begun;
        begun = false;
        long nextNanos = FIRST_LOOK_NANOS;
        for (WriteDeadline write : IN_PROGRESS) {
            nextNanos = Math.min(nextNanos, write.leftNanos(System.nanoTime()));
        }
        if (busy || !IN_PROGRESS.isEmpty()) {
            checkAfter(nextNanos);
            return;
        }
        MONITORED.set(false);
        if (!IN_PROGRESS.isEmpty()) {
            startMonitor();
        }
    }

    /** Returns the time to the next check of this write; aborts one that is late for the second time. */
    long leftNanos(long nowNanos) {
        long left = dueNanos - nowNanos;
        if (left > 0) {
            return left;
        }
        if (!foundLate) {
            foundLate = true;
            dueNanos = nowNanos + CONFIRM_NANOS;
            return CONFIRM_NANOS;
        }
        IN_PROGRESS.remove(this);
        passed = true;
        daemon(link::abort, "aborting " + link.address()).start();
        return FIRST_LOOK_NANOS;
    }

    private static Thread daemon(Runnable body, String name) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }
}
