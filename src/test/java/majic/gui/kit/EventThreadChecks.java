package majic.gui.kit;

import org.jspecify.annotations.Nullable;

/**
 * Fails a test that changes components on a thread that may not change them, or that keeps the event dispatch thread
 * busy for a second once its window is open.
 */
public final class EventThreadChecks implements AutoCloseable {
    private final EventThreadGuard guard = EventThreadGuard.install();
    private @Nullable EventThreadWatch watch;

    /** Begins to watch for stalls as well; to be called when the window is open, which may take longer. */
    public void windowIsOpen() {
        watch = EventThreadWatch.start();
    }

    @Override
    public void close() {
        try {
            if (watch != null) {
                watch.checkAndEnd();
            }
        } finally {
            guard.checkAndRemove();
        }
    }
}
