package majic.link;

import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** Aborts a link whose write does not come back in time; that wakes the writer. One thread watches all writes. */
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
        link.abort();
    }

    boolean passed() {
        return passed;
    }

    @Override
    public void close() {
        alarm.cancel(false);
    }

    private static ScheduledThreadPoolExecutor watch() {
        ScheduledThreadPoolExecutor watch = new ScheduledThreadPoolExecutor(1, body -> {
            Thread thread = new Thread(body, "link write deadlines");
            thread.setDaemon(true);
            return thread;
        });
        watch.setRemoveOnCancelPolicy(true);
        return watch;
    }
}
