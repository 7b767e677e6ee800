package majic.script;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import majic.bot.Member;

/** How often robots were stopped, so that a line can see later that its robots were stopped since. Thread-safe. */
final class StopCount {
    /** Whose stop the current thread carries out; the counts of each source of lines leave its own stops out. */
    private static final ThreadLocal<StopCount> BY = new ThreadLocal<>();

    private final Map<Integer, Long> single = new HashMap<>();
    private long all;

    /** Runs something that stops robots on this thread; those stops count here as well. */
    void during(Runnable stopping) {
        BY.set(this);
        try {
            stopping.run();
        } finally {
            BY.remove();
        }
    }

    /** Counts a stop, and counts it for the source of the line that this thread carries out. */
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

    /** Counts a STOP, and counts it for the source of the line that this thread carries out. */
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

    /** How often any of some robots was stopped, but for the stops that a source carried out. */
    synchronized long ofOthers(Collection<Integer> robots, StopCount source) {
        return of(robots) - source.of(robots);
    }

    /** How often STOP was pressed. */
    synchronized long all() {
        return all;
    }

    /** How often any of some robots was stopped, alone or with all. */
    synchronized long of(Collection<Integer> robots) {
        return all
                + robots.stream()
                        .mapToLong(robot -> single.getOrDefault(robot, 0L))
                        .sum();
    }
}
