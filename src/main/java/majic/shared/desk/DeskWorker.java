package majic.shared.desk;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Queue;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One thread that does, in order, what the thread of the connection must not wait for. Bounded: when too much waits,
 * more is refused. Thread-safe.
 */
final class DeskWorker implements AutoCloseable {
    private static final Logger LOG = System.getLogger(DeskWorker.class.getName());
    private static final int MOST_WAITING = 2000;

    private final Queue<Runnable> tasks = new ArrayDeque<>();
    private final Signal changed;
    private final Thread thread;
    private boolean closed;

    /** Creates the thread; {@link #start} starts it. */
    DeskWorker(TimeSource time, String name) {
        this.changed = time.signal();
        this.thread = time.thread(name, this::run);
    }

    void start() {
        thread.start();
    }

    /**
     * Adds a task; never blocks.
     *
     * @return whether there was room
     */
    boolean submit(Runnable task) {
        synchronized (this) {
            if (closed || tasks.size() >= MOST_WAITING) {
                return false;
            }
            tasks.add(task);
        }
        changed.raise();
        return true;
    }

    private void run() {
        try {
            while (!isClosed()) {
                changed.await(this::hasWork, Signal.FOR_EVER);
                for (Runnable task = next(); task != null; task = next()) {
                    runLoggingErrors(task);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void runLoggingErrors(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a message from the broker could not be handled", e);
        }
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    private synchronized boolean hasWork() {
        return closed || !tasks.isEmpty();
    }

    private synchronized @Nullable Runnable next() {
        return closed ? null : tasks.poll();
    }

    /** Ends the thread; what waits is dropped. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            tasks.clear();
        }
        changed.raise();
    }
}
