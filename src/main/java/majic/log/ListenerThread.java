package majic.log;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Passes lines to one listener, in order, on a thread of its own: a terminal that does not accept its lines delays
 * neither a STOP nor the other listeners. The thread does not use the session's clock, since it communicates with the
 * outside.
 */
final class ListenerThread {
    private static final Logger LOG = System.getLogger(ListenerThread.class.getName());
    private static final int MOST_WAITING = 100_000;

    private final SessionListener listener;
    private final BlockingQueue<Runnable> waiting = new LinkedBlockingQueue<>(MOST_WAITING);
    private volatile boolean ended;

    ListenerThread(SessionListener listener) {
        this.listener = listener;
    }

    ListenerThread start() {
        Thread thread = new Thread(this::passAll, "session listener");
        thread.setDaemon(true);
        thread.start();
        return this;
    }

    boolean isFor(SessionListener other) {
        return listener == other;
    }

    /** Queues a line; returns at once. If the listener is far too slow, lines are dropped. */
    void pass(Line line) {
        if (!waiting.offer(() -> listener.line(line))) {
            LOG.log(Level.DEBUG, "a listener is too far behind for: {0}", line);
        }
    }

    /** Runs a task once all lines so far are passed. */
    void afterwards(Runnable task) {
        if (!waiting.offer(task)) {
            task.run();
        }
    }

    /** Ends the thread once all lines so far are passed. */
    void end() {
        afterwards(() -> ended = true);
    }

    private void passAll() {
        try {
            while (!ended) {
                run(waiting.take());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void run(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "a listener of the session failed", e);
        }
    }
}
