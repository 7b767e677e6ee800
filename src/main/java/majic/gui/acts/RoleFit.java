package majic.gui.acts;

import java.util.List;
import java.util.Optional;
import majic.act.Role;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.team.Member;
import majic.text.Suggestion;
import majic.text.Texts;

/** Describes in words which robots can take a role, and why another robot cannot. */
final class RoleFit {
    private static final Texts TEXTS = Texts.of(RoleFit.class);

    private RoleFit() {}

    /** Describes what a role requires: {@code an aibo or pioneer with distanceFront}. */
    static String wanted(Role role) {
        String types = either(role).orElseGet(() -> TEXTS.get("anyRobot"));
        String robot = role.needs().isEmpty() ? types : TEXTS.get("with", types, String.join(", ", role.needs()));
        return role.several() ? TEXTS.get("oneOrMore", robot) : robot;
    }

    private static Optional<String> either(Role role) {
        return role.types().stream().reduce((types, type) -> TEXTS.get("either", types, type));
    }

    /** Returns why an act cannot be loaded onto a robot, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member) {
        MajicBot bot = member.bot();
        String type = bot.type().name();
        if (!role.takes(type)) {
            return either(role).map(types -> TEXTS.get("otherType", member.number(), type, types));
        }
        if (role.refusesAircraft(bot)) {
            return Optional.of(TEXTS.get("leavesGround", member.number()));
        }
        return role.missingParameter(bot)
                .map(missing -> {
                    List<String> has =
                            bot.parameters().stream().map(Parameter::name).toList();
                    return Suggestion.nearest(missing, has)
                            .map(meant -> TEXTS.get("noParameter.meant", member.number(), missing, meant))
                            .orElseGet(() -> TEXTS.get("noParameter", member.number(), missing));
                })
                .or(() -> role.missingCommand(bot).map(missing -> TEXTS.get("noCommand", member.number(), missing)));
    }

    /** Returns why a robot cannot take a further role, as a sentence; empty if it can. */
    static Optional<String> unfit(Role role, Member member, LoadTarget target) {
        if (member == target.member()) {
            return Optional.of(TEXTS.get("isMe", member.number()));
        }
        return unfit(role, member)
                .or(() -> Optional.ofNullable(target.inTheWayAt(member))
                        .map(owner -> LoadTarget.occupation(member, owner)));
    }
}
