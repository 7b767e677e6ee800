package majic.link;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Aborts a link whose write does not come back in time; that wakes the writer. One thread watches all writes; it leaves
 * the aborting, which a serial port's driver may hold up, to another one for each link. While there are writes it looks
 * after them by itself, for to wake it at each would take longer than the write.
 */
final class WriteDeadline implements AutoCloseable {
    private static final long DEADLINE_NANOS = TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS);
    private static final ScheduledThreadPoolExecutor WATCH =
            new ScheduledThreadPoolExecutor(1, body -> daemon(body, "link write deadlines"));
    private static final Set<WriteDeadline> UNDER_WAY = ConcurrentHashMap.newKeySet();
    private static final AtomicBoolean WATCHED = new AtomicBoolean();
    private static volatile boolean begun;

    private final Link link;
    private final long dueNanos = System.nanoTime() + DEADLINE_NANOS;
    private volatile boolean passed;

    private WriteDeadline(Link link) {
        this.link = link;
    }

    static WriteDeadline start(Link link) {
        WriteDeadline deadline = new WriteDeadline(link);
        UNDER_WAY.add(deadline);
        begun = true;
        beWatched();
        return deadline;
    }

    boolean passed() {
        return passed;
    }

    @Override
    public void close() {
        UNDER_WAY.remove(this);
    }

    private static void beWatched() {
        if (!WATCHED.get() && WATCHED.compareAndSet(false, true)) {
            lookAfter(DEADLINE_NANOS);
        }
    }

    private static void lookAfter(long nanos) {
        WATCH.schedule(WriteDeadline::look, nanos, TimeUnit.NANOSECONDS);
    }

    /** Goes on as long as writes are under way or have begun since the last look, which most often are over by now. */
    private static void look() {
        boolean busy = begun;
        begun = false;
        long nextNanos = DEADLINE_NANOS;
        for (WriteDeadline write : UNDER_WAY) {
            nextNanos = Math.min(nextNanos, write.leftNanos());
        }
        if (busy || !UNDER_WAY.isEmpty()) {
            lookAfter(nextNanos);
            return;
        }
        WATCHED.set(false);
        if (!UNDER_WAY.isEmpty()) {
            beWatched();
        }
    }

    /** Time to the next look at this write; a late one is ended and needs none. */
    private long leftNanos() {
        long left = dueNanos - System.nanoTime();
        if (left > 0) {
            return left;
        }
        UNDER_WAY.remove(this);
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
