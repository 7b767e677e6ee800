package majic.team;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * Records for each robot whether its newest stop was confirmed. The result of an older stop has no effect. Calls the
 * listeners only in {@link #publish()}. Thread-safe.
 */
final class StopReceipts {
    private final TeamEvents events;
    private final Roster roster;
    private final Map<Member, Receipt> receipts = new LinkedHashMap<>();
    private StopStatus status = StopStatus.NONE;
    private String elsewhere = "";
    private long stops;

    /**
     * The newest stop of a robot.
     *
     * @param stop its number
     * @param latched whether the robot counts among those that the latched STOP was meant for
     * @param confirmed whether the robot has confirmed it
     * @param pending whether it is unknown yet whether the robot confirms it
     * @param problem why this stop, or while it is pending an earlier one, was not confirmed; null if there is no
     *     reason
     */
    private record Receipt(
            long stop,
            boolean latched,
            boolean confirmed,
            boolean pending,
            @Nullable String problem) {
        boolean isPending(long number) {
            return stop == number && pending;
        }
    }

    StopReceipts(TeamEvents events, Roster roster) {
        this.events = events;
        this.roster = roster;
    }

    /**
     * Begins a stop; must be called before it is written.
     *
     * @param latches whether it is a STOP
     * @return its number, with which the robots' results are reported
     */
    synchronized long begin(Collection<Member> members, boolean latches) {
        stops++;
        for (Member member : members) {
            Receipt last = receipts.get(member);
            boolean latched = latches || (last != null && last.latched);
            receipts.put(member, new Receipt(stops, latched, false, true, last == null ? null : last.problem));
        }
        changed();
        return stops;
    }

    synchronized void confirmed(Member member, long stop) {
        receipts.computeIfPresent(
                member, (key, last) -> last.stop == stop ? new Receipt(stop, last.latched, true, false, null) : last);
        changed();
    }

    synchronized void failed(Member member, long stop, String reason) {
        receipts.computeIfPresent(
                member,
                (key, last) -> last.stop == stop ? new Receipt(stop, last.latched, false, false, reason) : last);
        changed();
    }

    /** The robots of which it is not known yet whether they confirm a stop. */
    synchronized List<Member> pending(long stop) {
        return receipts.entrySet().stream()
                .filter(entry -> entry.getValue().isPending(stop))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Marks a stop that is neither confirmed nor failed, but should be; either may follow. */
    synchronized void overdue(Member member, long stop, String problem) {
        receipts.computeIfPresent(
                member,
                (key, last) -> last.isPending(stop) ? new Receipt(stop, last.latched, false, true, problem) : last);
        changed();
    }

    /** Forgets the robots that are no longer in the team. */
    synchronized void removed() {
        changed();
    }

    /** Counts no robot as stopped by STOP any more; those that have not confirmed their stop are kept. */
    synchronized void released() {
        receipts.replaceAll(
                (member, last) -> new Receipt(last.stop, false, last.confirmed, last.pending, last.problem));
        elsewhere = "";
        changed();
    }

    /** Keeps why STOP has not reached other programs; empty if it has. */
    synchronized void elsewhere(String problem) {
        elsewhere = problem;
        changed();
    }

    synchronized StopStatus status() {
        return status;
    }

    /** Drops removed robots each time, because a stop may begin with a robot that is being removed. */
    private void changed() {
        receipts.keySet().retainAll(roster.all());
        int asked = 0;
        int confirmed = 0;
        SortedMap<Integer, String> unconfirmed = new TreeMap<>();
        for (Map.Entry<Member, Receipt> entry : receipts.entrySet()) {
            Receipt receipt = entry.getValue();
            asked += receipt.latched ? 1 : 0;
            confirmed += receipt.latched && receipt.confirmed ? 1 : 0;
            if (receipt.problem != null) {
                unconfirmed.put(entry.getKey().number(), receipt.problem);
            }
        }
        StopStatus now = new StopStatus(asked, confirmed, unconfirmed, elsewhere);
        if (!now.equals(status)) {
            status = now;
            events.put(listener -> listener.stopStatusChanged(now));
        }
    }

    /** Calls the listeners for each change, in order, on this thread or on one that does so already. */
    void publish() {
        events.deliver();
    }
}
