package majic.log;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/** Writes each line of a session to its log and passes it to all listeners, in one order for all. Thread-safe. */
public final class SessionOutput {
    private static final Logger LOG = LateLogger.of(SessionOutput.class);
    private static final long FLUSH_BOUND_MS = 1000;

    private final SessionLog log;
    private final List<ListenerThread> listeners = new CopyOnWriteArrayList<>();
    private final Object order = new Object();

    /**
     * Creates an output without listeners.
     *
     * @param log receives every line
     */
    public SessionOutput(SessionLog log) {
        this.log = log;
    }

    /** Starts a thread that passes lines to a listener. */
    public void addListener(SessionListener listener) {
        listeners.add(new ListenerThread(listener).start());
    }

    /** Ends the listener's thread once all lines so far were passed to it. */
    public void removeListener(SessionListener listener) {
        for (ListenerThread thread : listeners) {
            if (thread.isFor(listener) && listeners.remove(thread)) {
                thread.end();
            }
        }
    }

    /** Runs a task on a listener's thread once all lines so far were passed to it. Returns at once. */
    public void afterwards(SessionListener listener, Runnable task) {
        listeners.stream().filter(thread -> thread.isFor(listener)).forEach(thread -> thread.afterwards(task));
    }

    /** Waits until all listeners have received all lines so far, for one second at most. */
    public void flush() {
        CountDownLatch behind = new CountDownLatch(listeners.size());
        listeners.forEach(thread -> thread.afterwards(behind::countDown));
        try {
            if (!behind.await(FLUSH_BOUND_MS, TimeUnit.MILLISECONDS)) {
                LOG.log(Level.DEBUG, "a listener of the session does not take its lines");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Sends a line that concerns all; never waits. */
    public void send(Line.Kind kind, String text) {
        send(kind, text, null);
    }

    /**
     * Sends a line; never waits.
     *
     * @param asker the source of the line that this repeats or answers; null if it concerns all
     */
    public void send(Line.Kind kind, String text, @Nullable Object asker) {
        Line line = new Line(kind, text, asker);
        synchronized (order) {
            log.write(kind.name().toLowerCase(Locale.ROOT), line.text());
            listeners.forEach(thread -> thread.pass(listener -> listener.line(line)));
        }
    }

    /** Reports to all listeners what {@link SessionListener#loginRefused} describes; never waits. */
    public void loginRefused(String address, String again) {
        synchronized (order) {
            listeners.forEach(thread -> thread.pass(listener -> listener.loginRefused(address, again)));
        }
    }

    /**
     * Passes lines to one listener, in order, on a thread of its own: a terminal that does not accept its lines delays
     * neither a STOP nor the other listeners. The thread does not use the session's clock, since it communicates with
     * the outside.
     */
    private static final class ListenerThread {
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

        /** Queues a task; returns at once. If the listener is far too slow, tasks are dropped. */
        void pass(Consumer<SessionListener> event) {
            if (!waiting.offer(() -> event.accept(listener))) {
                LOG.log(Level.DEBUG, "a listener of the session is too far behind");
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
}
