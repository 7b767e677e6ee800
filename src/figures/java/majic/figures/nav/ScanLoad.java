package majic.figures.nav;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Stream;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.time.TimeSource;

/**
 * The processor time of each scan on the mapping thread, and the delay that it would have in real time. On a stepped
 * clock the thread has worked on all earlier scans when the next one comes, so the difference of the processor times at
 * two scans is that of the first one.
 */
final class ScanLoad implements ScanListener {
    private static final int LASER_BEAMS = 30;
    private static final double NANOS = 1e9;
    private static final String THREAD = "mapping";

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final TimeSource time;
    private final List<Double> arrivalsS = new ArrayList<>();
    private final List<Double> worksS = new ArrayList<>();
    private long thread = -1;
    private long before;

    ScanLoad(TimeSource time) {
        this.time = time;
    }

    @Override
    public synchronized void scanned(RangeScan scan) {
        if (scan.size() >= LASER_BEAMS) {
            count();
            arrivalsS.add(time.nanos() / NANOS);
        }
    }

    /** Adds the processor time since the last scan to that one. */
    synchronized void count() {
        long now = processorNanos();
        if (worksS.size() < arrivalsS.size()) {
            worksS.add((now - before) / NANOS);
        }
        before = now;
    }

    private long processorNanos() {
        if (thread < 0) {
            thread = Stream.of(threads.getThreadInfo(threads.getAllThreadIds()))
                    .filter(Objects::nonNull)
                    .filter(info -> info.getThreadName().equals(THREAD))
                    .mapToLong(ThreadInfo::getThreadId)
                    .findFirst()
                    .orElse(-1);
        }
        return thread < 0 ? 0 : Math.max(0, threads.getThreadCpuTime(thread));
    }

    /** Returns the share of a core and the delays. */
    synchronized String text() {
        double endS = 0;
        double longestS = 0;
        double sumS = 0;
        double latestS = 0;
        for (int scan = 0; scan < worksS.size(); scan++) {
            endS = Math.max(endS, arrivalsS.get(scan)) + worksS.get(scan);
            latestS = Math.max(latestS, endS - arrivalsS.get(scan));
            longestS = Math.max(longestS, worksS.get(scan));
            sumS += worksS.get(scan);
        }
        double lastedS = arrivalsS.get(arrivalsS.size() - 1) - arrivalsS.get(0);
        return String.format(
                Locale.ROOT,
                "mapping thread: %.2f s of processor time in %.0f s, %.1f %% of a core (at most 5 %%);"
                        + " %d laser scans, longest %.0f ms, latest %.0f ms after its arrival (at most 1 s)",
                sumS,
                lastedS,
                100 * sumS / lastedS,
                worksS.size(),
                1000 * longestS,
                1000 * latestS);
    }
}
