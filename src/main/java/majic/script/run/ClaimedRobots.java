package majic.script.run;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majic.team.Member;
import majic.team.Owner;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * The robots that a script owns: those it has commanded so far. A behaviour has them on loan, and neither takes
 * nor gives back any; a line has none. Used by one thread.
 */
final class ClaimedRobots {
    private final Team team;
    private final @Nullable Owner owner;
    private final boolean lent;
    private final Set<Member> used = new LinkedHashSet<>();

    /**
     * None as yet.
     *
     * @param owner their owner; null for a line
     * @param lent whether they are on loan to the owner
     */
    ClaimedRobots(Team team, @Nullable Owner owner, boolean lent) {
        this.team = team;
        this.owner = owner;
        this.lent = lent;
    }

    /** A snapshot. */
    Set<Member> all() {
        return Set.copyOf(used);
    }

    /**
     * Claims robots, which may be claimed already.
     *
     * @throws majic.bot.BotException if one has another owner; those before it were claimed
     */
    void claim(Collection<Member> members) {
        if (owner == null) {
            return;
        }
        for (Member member : members) {
            if (!lent) {
                member.claim(owner);
            }
            used.add(member);
        }
    }

    /** Stops and returns those that still do something, but for one, and those that a stop is on its way to. */
    Collection<Member> stopBusy(@Nullable Member exempt) {
        Collection<Member> busy = used.stream()
                .filter(member -> member != exempt && !member.isIdle(owner) && !member.isStopping())
                .toList();
        if (team.isLatched() || busy.isEmpty()) {
            return List.of();
        }
        team.stop(busy, owner);
        return busy;
    }

    /** Gives them all back. */
    void free() {
        if (owner != null) {
            used.forEach(member -> member.free(owner));
        }
    }
}
