package majic.gui.acts;

import java.util.Optional;
import majic.act.Role;
import majic.gui.kit.BotStatus;
import majic.team.Member;

/** Which robot can play which role, and why another cannot, in words. */
final class RoleFit {
    private RoleFit() {}

    /** What a role asks for: {@code an aibo or pioneer with distanceFront}. */
    static String wanted(Role role) {
        String types = role.types().isEmpty() ? "any robot" : String.join(" or ", role.types());
        String needs = role.needs().isEmpty() ? "" : " with " + String.join(", ", role.needs());
        return types + needs + (role.several() ? "; one or more" : "");
    }

    /** Why a robot cannot be the one a behaviour is loaded onto, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member) {
        return role.unfit(member.bot())
                .map(why -> "Robot " + member.number() + " " + why + (why.endsWith("?") ? "" : "."));
    }

    /** Why a robot cannot play a further role, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member, LoadTarget target) {
        if (member == target.member()) {
            return Optional.of("Robot " + member.number() + " is the one it is loaded onto.");
        }
        return unfit(role, member)
                .or(() -> Optional.ofNullable(target.inTheWayAt(member))
                        .map(owner -> "Robot " + member.number() + " is " + BotStatus.owner(member) + "."));
    }
}
