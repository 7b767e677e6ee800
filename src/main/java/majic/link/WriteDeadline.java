package majic.link;

import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Aborts a link whose write does not come back in time; that wakes the writer. One thread watches all writes; it leaves
 * the aborting, which a serial port's driver may hold up, to another one for each link.
 */
final class WriteDeadline implements AutoCloseable {
    private static final ScheduledThreadPoolExecutor WATCH = watch();

    private final ScheduledFuture<?> alarm;
    private volatile boolean passed;

    private WriteDeadline(Link link) {
        alarm = WATCH.schedule(() -> expire(link), Link.WRITE_DEADLINE_MS, TimeUnit.MILLISECONDS);
    }

    static WriteDeadline start(Link link) {
        return new WriteDeadline(link);
    }

    private void expire(Link link) {
        passed = true;
        daemon(link::abort, "aborting " + link.address()).start();
    }

    boolean passed() {
        return passed;
    }

    @Override
    public void close() {
        alarm.cancel(false);
    }

    private static ScheduledThreadPoolExecutor watch() {
        ScheduledThreadPoolExecutor watch =
                new ScheduledThreadPoolExecutor(1, body -> daemon(body, "link write deadlines"));
        watch.setRemoveOnCancelPolicy(true);
        return watch;
    }

    private static Thread daemon(Runnable body, String name) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }
}
