package majic.team;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;

/**
 * Counts stops by users, so that a queued line can see later that its robots were stopped since. The team counts a stop
 * on the thread that requests it, before it revokes anything. Thread-safe.
 */
public final class StopCount {
    /**
     * The source of the stop that the current thread runs; the counts of each source of lines exclude its own stops.
     */
    private static final ThreadLocal<StopCount> BY = new ThreadLocal<>();

    private final Map<Integer, Long> single = new HashMap<>();
    private long all;

    /**
     * Runs something that stops robots on this thread; those stops count here as well.
     *
     * @param stopping what to run
     */
    public void during(Runnable stopping) {
        BY.set(this);
        try {
            stopping.run();
        } finally {
            BY.remove();
        }
    }

    /** Counts a stop, and counts it for the source of the line that this thread runs. */
    synchronized void stopped(Collection<Member> members) {
        add(members);
        StopCount source = BY.get();
        if (source != null) {
            source.add(members);
        }
    }

    private synchronized void add(Collection<Member> members) {
        members.forEach(member -> single.merge(member.number(), 1L, Long::sum));
    }

    /** Counts a STOP, and counts it for the source of the line that this thread runs. */
    synchronized void stoppedAll() {
        addAll();
        StopCount source = BY.get();
        if (source != null) {
            source.addAll();
        }
    }

    private synchronized void addAll() {
        all++;
    }

    /**
     * Returns how often any of some robots was stopped, except by the stops of one source.
     *
     * @param robots their numbers
     * @param source the counts of that source
     * @return a count that only grows while the source stops nothing
     */
    public synchronized long ofOthers(Collection<Integer> robots, StopCount source) {
        return of(robots) - source.of(robots);
    }

    /**
     * Returns how often all robots were stopped by STOP.
     *
     * @return a count that only grows
     */
    public synchronized long all() {
        return all;
    }

    /**
     * Returns how often any of some robots was stopped, alone or with all.
     *
     * @param robots their numbers
     * @return a count that only grows
     */
    public synchronized long of(Collection<Integer> robots) {
        return all
                + robots.stream()
                        .mapToLong(robot -> single.getOrDefault(robot, 0L))
                        .sum();
    }
}
