package majic.script;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import majic.bot.Member;

/** How often robots were stopped, so that a line can see later that its robots were stopped since. Thread-safe. */
final class StopCount {
    private final Map<Integer, Long> single = new HashMap<>();
    private long all;

    synchronized void stopped(Collection<Member> members) {
        members.forEach(member -> single.merge(member.number(), 1L, Long::sum));
    }

    synchronized void stoppedAll() {
        all++;
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
