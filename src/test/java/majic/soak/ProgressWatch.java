package majic.soak;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Reports all threads if some of them block each other, or if nothing has advanced for two minutes. Uses a daemon
 * thread.
 */
final class ProgressWatch implements AutoCloseable {
    private static final long LOOK_MS = 1000;
    private static final int MOST_LOOKS = 120;

    private final LongSupplier progress;
    private final Consumer<String> report;
    private final Thread thread = new Thread(this::watch, "progress watch");

    /**
     * Begins to watch.
     *
     * @param progress a count that changes as long as something advances
     * @param report receives what is wrong, with all stacks, once
     */
    ProgressWatch(LongSupplier progress, Consumer<String> report) {
        this.progress = progress;
        this.report = report;
        thread.setDaemon(true);
        thread.start();
    }

    private void watch() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long last = progress.getAsLong();
        int unchanged = 0;
        try {
            while (unchanged < MOST_LOOKS && threads.findDeadlockedThreads() == null) {
                Thread.sleep(LOOK_MS);
                long now = progress.getAsLong();
                unchanged = now == last ? unchanged + 1 : 0;
                last = now;
            }
            report.accept((unchanged < MOST_LOOKS ? "threads block each other" : "nothing advances any more")
                    + stacks(threads));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static String stacks(ThreadMXBean threads) {
        StringBuilder all = new StringBuilder();
        for (ThreadInfo thread : threads.dumpAllThreads(true, true)) {
            all.append(System.lineSeparator()).append(thread);
        }
        return all.toString();
    }

    @Override
    public void close() {
        thread.interrupt();
    }
}
