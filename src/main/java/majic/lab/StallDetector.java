package majic.lab;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Collection;
import java.util.Map;
import java.util.StringJoiner;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Detects that a stepped clock has not advanced for so long that it will not continue, and reports what delays it. The
 * time starts again as long as members use the processor, because a long computation may delay the clock. Guarded by
 * the clock's lock, except {@link #stepped()}.
 */
final class StallDetector {
    private static final long NOT_READ = -1;
    private static final int MOST_FRAMES = 25;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final int stalledSeconds;
    private volatile long sinceNanos = System.nanoTime();
    private long usedNanos = NOT_READ;

    /** Creates one that takes a clock for stalled after so many seconds of real time. */
    StallDetector(int stalledSeconds) {
        this.stalledSeconds = stalledSeconds;
    }

    /** Records that the clock has taken a step, or that nothing waits for one. */
    void stepped() {
        sinceNanos = System.nanoTime();
    }

    /**
     * Returns whether nothing has happened for the time that makes a clock stalled. Reads the processor time of the
     * members only after half of that, because this is called at each wait of a member, and reading takes longer than a
     * step.
     */
    boolean isOver(Collection<Thread> members) {
        long stalledNanos = TimeUnit.SECONDS.toNanos(stalledSeconds);
        long waited = System.nanoTime() - sinceNanos;
        if (waited < stalledNanos / 2) {
            usedNanos = NOT_READ;
        } else if (usedNanos == NOT_READ) {
            usedNanos = processorNanos(members);
        } else if (waited >= stalledNanos) {
            if (processorNanos(members) == usedNanos) {
                return true;
            }
            stepped();
        }
        return false;
    }

    private long processorNanos(Collection<Thread> members) {
        return members.stream()
                .mapToLong(thread -> Math.max(0, threads.getThreadCpuTime(thread.getId())))
                .sum();
    }

    /** Reports everything that may delay the clock: its members, the connections, and the stacks of all threads. */
    String report(Map<Thread, ClockMember> members, String lines) {
        StringJoiner report = new StringJoiner("\n");
        report.add("the stepped clock has stood still for " + stalledSeconds + " s though a thread waits");
        members.forEach((thread, member) -> report.add("  " + thread.getName() + ": " + member));
        report.add("  " + lines);
        Thread.getAllStackTraces().forEach((thread, stack) -> {
            report.add("  " + thread.getName() + " (" + thread.getState() + ")");
            Stream.of(stack).limit(MOST_FRAMES).forEach(frame -> report.add("      at " + frame));
        });
        return report.toString();
    }
}
