package majic.script;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import majic.bot.BotException;
import majic.bot.Member;
import majic.bot.Team;

/** Finds the robots that a script names. */
final class Selection {
    private final Team team;
    private final OptionalInt me;

    /**
     * For one script.
     *
     * @param team the robots there are
     * @param me who {@code me} is; empty outside of a behaviour
     */
    Selection(Team team, OptionalInt me) {
        this.team = team;
        this.me = me;
    }

    /**
     * The robots named, each once.
     *
     * @throws ScriptException if a robot named by number is not there, or none of those that are chosen
     */
    List<Member> members(Robots robots) {
        Set<Member> found = new LinkedHashSet<>();
        robots.items().forEach(item -> found.addAll(members(item)));
        return List.copyOf(found);
    }

    /** As {@link #members}, leaving out what is not there. */
    List<Member> present(Robots robots) {
        Set<Member> found = new LinkedHashSet<>();
        for (Robots.Item item : robots.items()) {
            try {
                found.addAll(members(item));
            } catch (ScriptException e) {
                continue;
            }
        }
        return List.copyOf(found);
    }

    private List<Member> members(Robots.Item item) {
        if (item instanceof Robots.One one) {
            return List.of(member(one.at(), one.number()));
        }
        if (item instanceof Robots.Me mine) {
            return List.of(me(mine));
        }
        List<Member> chosen = new ArrayList<>(team.members());
        chosen.removeIf(member -> !isChosen(item, member));
        if (chosen.isEmpty()) {
            throw new ScriptException(item.at(), item.at().text() + ": there is no such robot (" + team.roll() + ")");
        }
        return chosen;
    }

    private Member me(Robots.Me item) {
        if (me.isEmpty()) {
            throw new ScriptException(item.at(), "me: only a behaviour has a robot of its own; write its number");
        }
        return member(item.at(), me.getAsInt());
    }

    private Member member(Token at, int number) {
        try {
            return team.member(number);
        } catch (BotException e) {
            throw new ScriptException(at, String.valueOf(e.getMessage()));
        }
    }

    private static boolean isChosen(Robots.Item item, Member member) {
        if (item instanceof Robots.Span span) {
            return member.number() >= span.first() && member.number() <= span.last();
        }
        return !(item instanceof Robots.OfType)
                || member.bot().type().name().equalsIgnoreCase(item.at().text());
    }
}
