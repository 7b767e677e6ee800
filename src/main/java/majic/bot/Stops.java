package majic.bot;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The stops that are on their way to one robot, and what each takes from those who have it. Guarded by the lock of the
 * robot's {@link Member}, but for what is to be told afterwards.
 */
final class Stops {
    private final Team team;
    private final MajicBot bot;
    private final Lane lane;
    private final Tenure tenure;
    private int underWay;

    /**
     * None as yet.
     *
     * @param lane the robot's own
     * @param tenure who has it
     */
    Stops(Team team, MajicBot bot, Lane lane, Tenure tenure) {
        this.team = team;
        this.bot = bot;
        this.lane = lane;
        this.tenure = tenure;
    }

    /** Who is to hear of a stop, once the lock is not held any more. */
    record Aftermath(Map<Lane, List<Pending>> dropped, List<Owner> ended) {
        void tell() {
            dropped.forEach((from, orders) -> from.tellDropped(orders, "stopped"));
            ended.forEach(Owner::endWhateverHappens);
        }
    }

    boolean areUnderWay() {
        return underWay > 0;
    }

    /** One more is under way, though it takes nothing. */
    void hold() {
        underWay++;
    }

    /** One has arrived. */
    void end() {
        underWay--;
    }

    /** Empties the queues. A borrower who says so himself ends only what he has begun. */
    Aftermath begin(@Nullable Owner by) {
        hold();
        Map<Lane, List<Pending>> dropped = new LinkedHashMap<>();
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
