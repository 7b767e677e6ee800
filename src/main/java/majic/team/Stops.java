package majic.team;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.bot.MajicBot;
import org.jspecify.annotations.Nullable;

/**
 * The pending stops of one robot, and what each revokes from its owner and borrower. Guarded by the lock of the robot's
 * {@link Member}, except for the notifications afterwards.
 */
final class Stops {
    private final Team team;
    private final MajicBot bot;
    private final CommandQueue lane;
    private final Tenure tenure;
    private int underWay;

    /**
     * Creates the state without a pending stop.
     *
     * @param lane the robot's own queue
     * @param tenure the owner and borrower of the robot
     */
    Stops(Team team, MajicBot bot, CommandQueue lane, Tenure tenure) {
        this.team = team;
        this.bot = bot;
        this.lane = lane;
        this.tenure = tenure;
    }

    /**
     * The consequences of a stop, applied once it has been written to every connection and no lock is held.
     *
     * @param dropped the commands to report as not run
     * @param ended the owners to end
     */
    record Aftermath(Map<CommandQueue, List<QueuedCommand>> dropped, List<Owner> ended) {
        void tell() {
            dropped.forEach((from, commands) -> from.tellDropped(commands, "stopped"));
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
     * Revokes permissions and empties the queues; notifies nothing. Two holds begin, one for the robot's stop and one
     * for the notifications. A stop by the borrower itself ends only the borrower's own commands.
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
