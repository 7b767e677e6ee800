package majic.figures;

import com.sun.management.GarbageCollectionNotificationInfo;
import com.sun.management.OperatingSystemMXBean;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import javax.management.NotificationEmitter;
import javax.management.openmbean.CompositeData;

/**
 * What this process has used at one moment.
 *
 * @param nanos of the moment, {@link System#nanoTime}
 * @param cpuNanos processor time of all threads since the start
 * @param threads how many live, those of the Java machine included that {@link ThreadMXBean} counts
 */
record ProcessSample(long nanos, long cpuNanos, int threads) {
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    static ProcessSample now() {
        return new ProcessSample(
                System.nanoTime(),
                SYSTEM.getProcessCpuTime(),
                ManagementFactory.getThreadMXBean().getThreadCount());
    }

    /** Returns the bytes in use after full collections. */
    static long heapBytes() {
        for (int times = 0; times < 3; times++) {
            System.gc();
        }
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }

    /** Returns the processor time since an earlier sample, percent of one core. */
    double percentSince(ProcessSample earlier) {
        return 100.0 * (cpuNanos - earlier.cpuNanos) / (nanos - earlier.nanos);
    }

    /** Counts the collections of garbage from its creation on, and finds the longest. */
    static final class Pauses {
        private final AtomicLong count = new AtomicLong();
        private final AtomicLong longestMs = new AtomicLong();

        Pauses() {
            List<GarbageCollectorMXBean> collectors = ManagementFactory.getGarbageCollectorMXBeans();
            for (GarbageCollectorMXBean collector : collectors) {
                ((NotificationEmitter) collector)
                        .addNotificationListener((notification, none) -> add(notification.getUserData()), null, null);
            }
        }

        private void add(Object data) {
            if (data instanceof CompositeData pause) {
                count.incrementAndGet();
                longestMs.accumulateAndGet(
                        GarbageCollectionNotificationInfo.from(pause)
                                .getGcInfo()
                                .getDuration(),
                        Math::max);
            }
        }

        /** Forgets all so far. */
        void reset() {
            count.set(0);
            longestMs.set(0);
        }

        long count() {
            return count.get();
        }

        long longestMs() {
            return longestMs.get();
        }
    }
}
