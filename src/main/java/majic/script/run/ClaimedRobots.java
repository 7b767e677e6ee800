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
 * The robots that a script has commanded so far and therefore owns. Those of a behaviour are lent to it, so it neither
 * claims nor frees any. Used by one thread.
 */
final class ClaimedRobots {
    private final Team team;
    private final Owner owner;
    private final boolean lent;
    private final Set<Member> used = new LinkedHashSet<>();

    /**
     * None as yet.
     *
     * @param owner their owner or borrower
     * @param lent whether they are lent to it
     */
    ClaimedRobots(Team team, Owner owner, boolean lent) {
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
        for (Member member : members) {
            if (!lent) {
                member.claim(owner);
            }
            used.add(member);
        }
    }

    /** Stops and returns those that are busy, except one, and except those with a pending stop. */
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

    /** Releases them all. */
    void free() {
        used.forEach(member -> member.free(owner));
    }
}
