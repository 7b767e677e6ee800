package majic.team;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/**
 * The stops that are on their way to one robot, and what each takes from those who have it. Guarded by the lock of the
 * robot's {@link Member}, but for what is to be told afterwards.
 */
final class Stops {
    private final Team team;
    private final MajicBot bot;
    private final CommandQueue lane;
    private final Tenure tenure;
    private int underWay;

    /**
     * None as yet.
     *
     * @param lane the robot's own
     * @param tenure who has it
     */
    Stops(Team team, MajicBot bot, CommandQueue lane, Tenure tenure) {
        this.team = team;
        this.bot = bot;
        this.lane = lane;
        this.tenure = tenure;
    }

    /**
     * What follows from a stop, once it has been written to every link and no lock is held.
     *
     * @param dropped what is to be told as not run
     * @param ended the owners that are to end
     */
    record Aftermath(Map<CommandQueue, List<QueuedCommand>> dropped, List<Owner> ended) {
        void tell() {
            dropped.forEach((from, orders) -> from.tellDropped(orders, "stopped"));
        }
    }

    boolean areUnderWay() {
        return underWay > 0;
    }

    /** One of the holds has ended. */
    void end() {
        underWay--;
    }

    /**
     * Revokes and empties the queues; notifies nothing. Two holds begin, one for the robot's stop and one for the
     * notifications. A borrower who says so himself ends only what he has begun.
     */
    Aftermath begin(@Nullable Owner by) {
        underWay += 2;
        Map<CommandQueue, List<QueuedCommand>> dropped = new LinkedHashMap<>();
        Loan his = team.isLatched() ? null : tenure.loanTo(by);
        if (his != null) {
            dropped.put(his.lane(), his.stop());
            return new Aftermath(dropped, List.of());
        }
        revoke();
        List<Owner> ended = tenure.dismiss(by);
        tenure.lanes(lane).forEach(all -> dropped.put(all, all.drop()));
        return new Aftermath(dropped, ended);
    }

    private void revoke() {
        if (team.isLatched()) {
            bot.latch();
        } else {
            bot.revokeMotions();
        }
    }
}
