package majic.script;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Tells one listener all that is said, in order, on a thread of its own: a terminal that does not take its lines holds
 * up neither a STOP nor anybody else. The thread is outside of the session's clock, since it deals with the world.
 */
final class Listening {
    private static final Logger LOG = System.getLogger(Listening.class.getName());
    private static final int MOST_UNHEARD = 100_000;

    private final SessionListener listener;
    private final BlockingQueue<Runnable> unheard = new LinkedBlockingQueue<>(MOST_UNHEARD);
    private volatile boolean ended;

    Listening(SessionListener listener) {
        this.listener = listener;
    }

    Listening start() {
        Thread thread = new Thread(this::tellAll, "session listener");
        thread.setDaemon(true);
        thread.start();
        return this;
    }

    boolean isTo(SessionListener other) {
        return listener == other;
    }

    /** Returns at once; when the listener is far too slow, lines get lost. */
    void tell(Line line) {
        if (!unheard.offer(() -> listener.line(line))) {
            LOG.log(Level.DEBUG, "a listener is too far behind for: {0}", line);
        }
    }

    /** Does something once all that was said so far has been heard. */
    void afterwards(Runnable task) {
        if (!unheard.offer(task)) {
            task.run();
        }
    }

    /** Ends once all that was said so far has been heard. */
    void end() {
        afterwards(() -> ended = true);
    }

    private void tellAll() {
        try {
            while (!ended) {
                tell(unheard.take());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void tell(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "a listener of the session failed", e);
        }
    }
}
