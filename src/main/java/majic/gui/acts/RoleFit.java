package majic.gui.acts;

import java.util.Optional;
import majic.act.Role;
import majic.gui.kit.BotStatus;
import majic.team.Member;

/** Describes in words which robots can take a role, and why another robot cannot. */
final class RoleFit {
    private RoleFit() {}

    /** Describes what a role requires: {@code an aibo or pioneer with distanceFront}. */
    static String wanted(Role role) {
        String types = role.types().isEmpty() ? "any robot" : String.join(" or ", role.types());
        String needs = role.needs().isEmpty() ? "" : " with " + String.join(", ", role.needs());
        return types + needs + (role.several() ? "; one or more" : "");
    }

    /** Returns why an act cannot be loaded onto a robot, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member) {
        return role.unfit(member.bot())
                .map(why -> "Robot " + member.number() + " " + why + (why.endsWith("?") ? "" : "."));
    }

    /** Returns why a robot cannot take a further role, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member, LoadTarget target) {
        if (member == target.member()) {
            return Optional.of("Robot " + member.number() + " is the one it is loaded onto.");
        }
        return unfit(role, member)
                .or(() -> Optional.ofNullable(target.inTheWayAt(member))
                        .map(owner -> "Robot " + member.number() + " is " + BotStatus.owner(member) + "."));
    }
}
