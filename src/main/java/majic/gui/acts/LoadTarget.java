package majic.gui.acts;

import java.util.List;
import majic.script.ActOffer;
import majic.team.Member;
import majic.team.Owner;
import org.jspecify.annotations.Nullable;

/**
 * The robot that is to get a behaviour.
 *
 * @param member the robot
 * @param ends what runs on it and, as the person agreed, ends for the new behaviour; null if nothing ran
 */
public record LoadTarget(Member member, @Nullable Owner ends) {
    static LoadTarget of(Member member) {
        return new LoadTarget(member, member.owner());
    }

    /**
     * What is to be said to give it a behaviour. The old one ends only here, so that giving up before changes nothing;
     * one that came meanwhile, to whose end nobody agreed, is left alone and in the way. A behaviour that a script runs
     * ends with its script, which would go on otherwise.
     *
     * @param others the numbers of the further robots, in the order of the roles
     */
    String lines(ActOffer offer, List<Integer> others) {
        int number = member.number();
        String start = offer.line(number, others);
        Owner now = member.owner();
        if (now == null || now != ends) {
            return start;
        }
        boolean isItsOwn = now.kind() == Owner.Kind.ACT && member.lender() == null;
        String end = isItsOwn ? " act off" : " stop";
        return number + end + "\n" + number + " wait\n" + start;
    }

    /** What runs on another robot and is in the way there; what ends for the new behaviour is not. */
    @Nullable
    Owner inTheWayAt(Member other) {
        Owner owner = other.owner();
        return owner == ends ? null : owner;
    }
}
