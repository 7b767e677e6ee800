package majic.soak;

import com.sun.management.UnixOperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What this program holds.
 *
 * @param threads those that are alive
 * @param handles open files and sockets; 0 where the system does not count them
 * @param heapBytes in use after a collection
 */
record Resources(Set<Thread> threads, long handles, long heapBytes) {
    private static final int END_BOUND_MS = 10_000;

    /** A thread that the library JNA begins and ends as it needs it. */
    private static final String OF_JNA = "JNA Cleaner";

    static Resources now() {
        System.gc();
        long handles = ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean unix
                ? unix.getOpenFileDescriptorCount()
                : 0;
        long heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
        return new Resources(Thread.getAllStackTraces().keySet(), handles, heap);
    }

    /** Returns what there is when the threads that were not there before have had ten seconds each to end. */
    static Resources settledSince(Resources before) throws InterruptedException {
        for (Thread thread : now().threadsSince(before)) {
            thread.join(END_BOUND_MS);
        }
        return now();
    }

    /** Returns in words what there is more than before, but for the heap; empty if nothing is. */
    List<String> leftOverSince(Resources before) {
        List<String> more =
                threadsSince(before).stream().map(Thread::getName).sorted().collect(Collectors.toList());
        if (handles > before.handles) {
            more.add(handles - before.handles + " handles");
        }
        return more;
    }

    private Set<Thread> threadsSince(Resources before) {
        Set<Thread> since = new HashSet<>(threads);
        since.removeAll(before.threads);
        since.removeIf(thread -> thread.getName().equals(OF_JNA));
        return since;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT, "%d threads, %d handles, %.1f MB of heap", threads.size(), handles, heapBytes / 1e6);
    }
}
