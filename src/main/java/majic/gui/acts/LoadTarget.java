package majic.gui.acts;

import java.util.List;
import majic.script.ActOffer;
import majic.team.Member;
import majic.team.Owner;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The robot onto which an act is to be loaded.
 *
 * @param member the robot
 * @param ends the owner that, with the user's consent, is ended for the new act; null if there was none
 */
public record LoadTarget(Member member, @Nullable Owner ends) {
    private static final Texts TEXTS = Texts.of(LoadTarget.class);

    static LoadTarget of(Member member) {
        return new LoadTarget(member, member.owner());
    }

    /**
     * Returns the command lines that load the act. The previous owner is ended only by these lines, so that cancelling
     * earlier changes nothing. An owner that started since then, for which there is no consent, is not ended, and the
     * load is refused. An act that a script runs is ended together with its script, which would continue otherwise.
     *
     * @param others the numbers of the further robots, in the order of the roles
     */
    String lines(ChosenAct act, List<Integer> others) {
        int number = member.number();
        String start = act.line(number, others);
        Owner now = member.owner();
        if (now == null || now != ends) {
            return start;
        }
        boolean isItsOwn = now.kind() == Owner.Kind.ACT && member.sublessor() == null;
        String end = isItsOwn ? ActOffer.endLine(List.of(number)) : number + " stop";
        return end + "\n" + number + " wait\n" + start;
    }

    /** Returns what a robot does for its owner, as a sentence. */
    static String occupation(Member member, Owner owner) {
        if (owner.kind() == Owner.Kind.MANUAL) {
            return TEXTS.get("drivenByHand", member.number());
        }
        if (owner.kind() == Owner.Kind.REMOTE) {
            return TEXTS.get("held", member.number(), owner.name());
        }
        Owner below = member.sublessor();
        return below == null
                ? TEXTS.get("running", member.number(), owner.name())
                : TEXTS.get("runningInScript", member.number(), owner.name(), below.name());
    }

    /**
     * Returns the owner that prevents another robot from being used; the owner that ends for the new act is not
     * counted.
     */
    @Nullable
    Owner inTheWayAt(Member other) {
        Owner owner = other.owner();
        return owner == ends ? null : owner;
    }
}
