package majic.team;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majic.bot.BotState;

/**
 * Reports robots that have not confirmed a stop within {@value #OVERDUE_S} s. Drivers wait longer, because a fast robot
 * takes longer to come to rest; a robot that reports that it slows down is therefore left out. Thread-safe.
 */
final class OverdueStops {
    /** Together with the time to show it, less than one second. */
    private static final double OVERDUE_S = 0.8;

    /** The part of its speed at which a robot counts as slowing down. */
    private static final double SLOWED = 0.9;

    private static final String PROBLEM = "not confirmed within " + OVERDUE_S + " s";

    private final TeamEvents events;
    private final StopReceipts receipts;

    OverdueStops(TeamEvents events, StopReceipts receipts) {
        this.events = events;
        this.receipts = receipts;
    }

    /**
     * Keeps the speeds of robots that are about to be stopped.
     *
     * @param stop the number of the stop
     * @return starts to wait on another thread until all have confirmed the stop or failed to, or are overdue
     */
    Runnable watch(Collection<Member> members, long stop) {
        Map<Member, BotState> before = new HashMap<>();
        members.forEach(member -> before.put(member, member.bot().state()));
        return () -> events.time().tryRunAsync("overdue stops", () -> await(before, stop));
    }

    private void await(Map<Member, BotState> before, long stop) {
        try {
            if (!events.changes().await(() -> receipts.pending(stop).isEmpty(), OVERDUE_S)) {
                report(before, stop);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void report(Map<Member, BotState> before, long stop) {
        List<Member> late = receipts.pending(stop).stream()
                .filter(member -> !slowsDown(
                        before.getOrDefault(member, BotState.UNKNOWN),
                        member.bot().state()))
                .toList();
        late.forEach(member -> receipts.overdue(member, stop, PROBLEM));
        if (!late.isEmpty()) {
            events.put(listener -> listener.stopOverdue(late, OVERDUE_S));
        }
        events.changes().raise();
        events.deliver();
    }

    private static boolean slowsDown(BotState before, BotState now) {
        return isLess(now.speedMmPerSec(), before.speedMmPerSec())
                || isLess(now.turnRateDegPerSec(), before.turnRateDegPerSec());
    }

    private static boolean isLess(double now, double before) {
        return Math.abs(now) < SLOWED * Math.abs(before);
    }
}
