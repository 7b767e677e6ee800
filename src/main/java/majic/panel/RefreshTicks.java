package majic.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/**
 * The moments, ten times a second, at which all parts of all windows show what has changed. They share these moments,
 * so that the event dispatch thread wakes up and paints once for all of them. There are none while nothing is to be
 * shown.
 */
public final class RefreshTicks {
    public static final int PERIOD_MS = 100;

    /** Used on the event dispatch thread only. */
    private static final List<Runnable> REPEATED = new ArrayList<>();

    private static final Set<Runnable> DUE = ConcurrentHashMap.newKeySet();
    private static final Timer TIMER = new Timer(PERIOD_MS, event -> tick());
    private static volatile boolean running;

    private RefreshTicks() {}

    /**
     * Runs an update at the next tick, once, however often this is called before. Callable from any thread.
     *
     * @param update runs on the event dispatch thread; the same object at each call
     */
    public static void once(Runnable update) {
        if (DUE.add(update) && !running) {
            SwingUtilities.invokeLater(RefreshTicks::startOrStop);
        }
    }

    /** Runs an update at every tick until it is removed. Must be called on the event dispatch thread. */
    static void add(Runnable update) {
        REPEATED.add(update);
        startOrStop();
    }

    /**
     * Ends what {@link #add} began; no effect for an update that was not added. Must be called on the event dispatch
     * thread.
     */
    static void remove(Runnable update) {
        REPEATED.remove(update);
    }

    private static void tick() {
        List<Runnable> updates = new ArrayList<>(REPEATED);
        DUE.removeIf(updates::add);
        updates.forEach(RefreshTicks::attempt);
        startOrStop();
    }

    /** An update that fails, perhaps of a plug-in's panel, does not delay the others. */
    private static void attempt(Runnable update) {
        try {
            update.run();
        } catch (RuntimeException | Error e) {
            Thread thread = Thread.currentThread();
            thread.getUncaughtExceptionHandler().uncaughtException(thread, e);
        }
    }

    /** An update that becomes due while the timer is stopped either is found here or finds that it is not running. */
    private static void startOrStop() {
        running = false;
        running = !REPEATED.isEmpty() || !DUE.isEmpty();
        if (!running) {
            TIMER.stop();
        } else if (!TIMER.isRunning()) {
            TIMER.start();
        }
    }
}
