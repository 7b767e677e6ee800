package majic.script.conditions;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/** Finds the robots that a script names. */
public final class Selection {
    private final Supplier<List<Member>> all;
    private final IntFunction<Member> byNumber;
    private final @Nullable Member me;

    /**
     * For everything but behaviours.
     *
     * @param team the robots there are
     */
    public Selection(Team team) {
        this.all = team::members;
        this.byNumber = team::member;
        this.me = null;
    }

    /**
     * For a behaviour, which can use only its own robots.
     *
     * @param me the robot it runs on
     * @param numbers which robot is meant by a number in it
     */
    public Selection(Member me, Map<Integer, Member> numbers) {
        this.all = () -> Stream.concat(Stream.of(me), numbers.values().stream())
                .distinct()
                .toList();
        this.byNumber = number -> Optional.ofNullable(numbers.get(number))
                .orElseThrow(() -> new BotException(number + ": the act was given no such robot"));
        this.me = me;
    }

    /**
     * The robots named, each once; none for null.
     *
     * @throws ScriptException if a robot named by number is not there, or none of those that are chosen
     */
    public List<Member> members(@Nullable Robots robots) {
        if (robots == null) {
            return List.of();
        }
        Set<Member> found = new LinkedHashSet<>();
        robots.items().forEach(item -> found.addAll(members(item)));
        return List.copyOf(found);
    }

    /** As {@link #members}, leaving out what is not there. */
    public List<Member> present(@Nullable Robots robots) {
        if (robots == null) {
            return List.of();
        }
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

    /** The names that robots have. */
    public List<String> names() {
        return all.get().stream()
                .map(Member::name)
                .filter(name -> !name.isEmpty())
                .toList();
    }

    private List<Member> members(Robots.Item item) {
        if (item instanceof Robots.One one) {
            return List.of(member(one.at(), one.number()));
        }
        if (item instanceof Robots.Me mine) {
            return List.of(me(mine));
        }
        List<Member> chosen = new ArrayList<>(all.get());
        chosen.removeIf(member -> !isChosen(item, member));
        if (chosen.isEmpty()) {
            throw new ScriptException(
                    item.at(), item.at().text() + ": there is no such robot (" + Team.listing(all.get()) + ")");
        }
        return chosen;
    }

    private Member me(Robots.Me item) {
        if (me == null) {
            throw new ScriptException(item.at(), "me: only an act has a robot of its own; write its number");
        }
        return me;
    }

    private Member member(Token at, int number) {
        return at.resolve(() -> byNumber.apply(number));
    }

    private static boolean isChosen(Robots.Item item, Member member) {
        if (item instanceof Robots.Span span) {
            return member.number() >= span.first() && member.number() <= span.last();
        }
        String word = item.at().text();
        return !(item instanceof Robots.Named)
                || member.bot().type().name().equalsIgnoreCase(word)
                || member.name().equalsIgnoreCase(word);
    }
}
