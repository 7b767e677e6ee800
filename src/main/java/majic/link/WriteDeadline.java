package majic.link;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Aborts a link whose write does not return in time, which wakes the writer. One thread monitors all writes; the abort,
 * which the driver of a serial port may block, runs on a thread of its own. The monitor runs by itself while there are
 * writes; waking it for each write would cost more than the write.
 */
final class WriteDeadline implements AutoCloseable {
    private static final long DEADLINE_NANOS = TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS);
    private static final ScheduledThreadPoolExecutor MONITOR =
            new ScheduledThreadPoolExecutor(1, body -> daemon(body, "link write deadlines"));
    private static final Set<WriteDeadline> IN_PROGRESS = ConcurrentHashMap.newKeySet();
    private static final AtomicBoolean MONITORED = new AtomicBoolean();
    private static volatile boolean begun;

    private final Link link;
    private final long dueNanos = System.nanoTime() + DEADLINE_NANOS;
    private volatile boolean passed;

    private WriteDeadline(Link link) {
        this.link = link;
    }

    static WriteDeadline start(Link link) {
        WriteDeadline deadline = new WriteDeadline(link);
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
            checkAfter(DEADLINE_NANOS);
        }
    }

    private static void checkAfter(long nanos) {
        MONITOR.schedule(WriteDeadline::check, nanos, TimeUnit.NANOSECONDS);
    }

    /** Reschedules itself while writes are in progress or have begun since the last check. */
    private static void check() {
        boolean busy = begun;
        begun = false;
        long nextNanos = DEADLINE_NANOS;
        for (WriteDeadline write : IN_PROGRESS) {
            nextNanos = Math.min(nextNanos, write.leftNanos());
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

    /** Time to the next check of this write; aborts a late one. */
    private long leftNanos() {
        long left = dueNanos - System.nanoTime();
        if (left > 0) {
            return left;
        }
        IN_PROGRESS.remove(this);
        passed = true;
        daemon(link::abort, "aborting " + link.address()).start();
        return DEADLINE_NANOS;
    }

    private static Thread daemon(Runnable body, String name) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }
}
