package majic.gui.plot;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.locks.LockSupport;

/**
 * Paints the charts of all plots, one after the other, on one thread that leaves two thirds of a processor core to
 * others.
 */
final class PaintThread {
    private static final int REST_PER_WORK = 2;

    private static final ExecutorService THREAD = Executors.newSingleThreadExecutor(PaintThread::thread);

    private PaintThread() {}

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "plot painter");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        return thread;
    }

    /** Runs a task behind those that wait already. */
    static void run(Runnable painting) {
        THREAD.execute(() -> {
            long startNanos = System.nanoTime();
            painting.run();
            LockSupport.parkNanos(REST_PER_WORK * (System.nanoTime() - startNanos));
        });
    }
}
