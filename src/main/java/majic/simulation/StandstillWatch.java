package majic.simulation;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Collection;
import java.util.Map;
import java.util.StringJoiner;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Tells when a stepped clock has stood still for so long that it will not go on, and what holds it. The time counts anew
 * as long as members use the processor: a long computation holds the clock by right. Guarded by the clock's lock, but
 * for {@link #stepped()}.
 */
final class StandstillWatch {
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final int MOST_FRAMES = 25;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private volatile long sinceNanos = System.nanoTime();
    private long usedNanos;

    /** The clock has stepped, or nothing waits for it to. */
    void stepped() {
        sinceNanos = System.nanoTime();
    }

    /** Whether nothing has happened for 10 s of real time. */
    boolean isOver(Collection<Thread> members) {
        long now = System.nanoTime();
        if (now - sinceNanos < PATIENCE_NANOS / 2) {
            usedNanos = processorNanos(members);
        } else if (now - sinceNanos >= PATIENCE_NANOS) {
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

    /** All that may hold the clock: its members, the lines, and the stacks of all threads. */
    String report(Map<Thread, ClockMember> members, String lines) {
        StringJoiner report = new StringJoiner("\n");
        report.add(
                "the stepped clock has stood still for " + PATIENCE_NANOS / 1_000_000_000 + " s though a thread waits");
        members.forEach((thread, member) -> report.add("  " + thread.getName() + ": " + member));
        report.add("  " + lines);
        Thread.getAllStackTraces().forEach((thread, stack) -> {
            report.add("  " + thread.getName() + " (" + thread.getState() + ")");
            Stream.of(stack).limit(MOST_FRAMES).forEach(frame -> report.add("      at " + frame));
        });
        return report.toString();
    }
}
