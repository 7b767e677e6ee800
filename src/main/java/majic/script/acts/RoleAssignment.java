package majic.script.acts;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.act.Role;
import majic.bot.BotException;
import majic.script.record.SessionRecord;
import majic.team.Member;

/** Assigns the robots of a line to the roles of a behaviour, in the order they are named. */
public final class RoleAssignment {
    private RoleAssignment() {}

    /**
     * Assigns robots to roles.
     *
     * @param act the behaviour, as it was typed
     * @param me the robot it is loaded onto
     * @param others the further robots
     * @return at least one robot for each role, in the order of the roles
     * @throws BotException if they are too few, too many, or do not fit their roles
     */
    public static Map<String, List<Member>> assign(String act, List<Role> roles, Member me, List<Member> others) {
        List<Member> robots = new ArrayList<>(List.of(me));
        robots.addAll(others);
        Role last = roles.get(roles.size() - 1);
        if (robots.size() < roles.size() || (robots.size() > roles.size() && !last.several())) {
            throw new BotException(act + ": " + wanted(act, roles, me, others.size()));
        }
        Map<String, List<Member>> assigned = new LinkedHashMap<>();
        for (int index = 0; index < robots.size(); index++) {
            Role role = roles.get(Math.min(index, roles.size() - 1));
            Member member = robots.get(index);
            check(act, role, member);
            if (robots.indexOf(member) < index) {
                throw new BotException(act + ": robot " + member.number() + " cannot have two roles");
            }
            assigned.computeIfAbsent(role.name(), key -> new ArrayList<>()).add(member);
        }
        return assigned;
    }

    private static void check(String act, Role role, Member member) {
        role.unfit(member.bot()).ifPresent(why -> {
            throw new BotException(act + ": robot " + member.number() + " " + why);
        });
    }

    private static String wanted(String act, List<Role> roles, Member me, int others) {
        if (roles.size() == 1) {
            return "needs no further robot than the one it runs on";
        }
        List<Role> further = roles.subList(1, roles.size());
        boolean several = further.get(further.size() - 1).several();
        String numbers = String.join(",", further.stream().map(role -> "N").toList());
        boolean tooMany = others > further.size();
        return (tooMany ? "takes " : "needs ") + further.size() + (several ? " or more others (" : " more (")
                + String.join(", ", further.stream().map(Role::toString).toList())
                + (tooMany ? "), not " + others + ": " : "): ") + me.number()
                + " act " + SessionRecord.quoted(act) + " with " + numbers + (several ? ",…" : "");
    }
}
