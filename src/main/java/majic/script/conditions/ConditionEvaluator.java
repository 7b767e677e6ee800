package majic.script.conditions;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.script.syntax.Condition;
import majic.script.syntax.EachComparison;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Evaluates a condition by reading the robots it names. */
public final class ConditionEvaluator implements Condition.Visitor<Truth> {
    private final Selection selection;
    private final @Nullable Member own;

    /**
     * For the conditions of one command.
     *
     * @param selection finds robots
     * @param own whose parameters are meant where no robot is named; null where there is none
     */
    public ConditionEvaluator(Selection selection, @Nullable Member own) {
        this.selection = selection;
        this.own = own;
    }

    @Override
    public Truth or(Condition.Or or) {
        return or.left().accept(this).or(or.right().accept(this));
    }

    @Override
    public Truth and(Condition.And and) {
        return and.left().accept(this).and(and.right().accept(this));
    }

    @Override
    public Truth not(Condition.Not not) {
        return not.inner().accept(this).not();
    }

    @Override
    public Truth comparison(Condition.Comparison comparison) {
        boolean any = comparison.robots() != null && comparison.robots().isAny();
        Truth all = Truth.of(!any);
        for (Member member : asked(comparison, selection, own)) {
            Truth one = ask(comparison, member);
            all = any ? all.or(one) : all.and(one);
        }
        return all;
    }

    @Override
    public Truth known(Condition.Known known) {
        return Truth.of(Comparisons.holds(
                known.left().computable(), known.operator(), known.right().computable()));
    }

    private Truth ask(Condition.Comparison comparison, Member member) {
        String robot = member == own ? "" : member.number() + " ";
        try {
            Truth truth = Comparisons.of(comparison, member.bot());
            return truth.undecided() == null ? truth : Truth.unknown(robot + truth.undecided());
        } catch (MotionStopped e) {
            throw e;
        } catch (BotException | ScriptException e) {
            return Truth.unknown(robot + comparison.parameter().text() + " is unknown (" + e.getMessage() + ")");
        }
    }

    /**
     * The robots that a comparison reads.
     *
     * @throws ScriptException if they are not there, or none is named and the command has none of its own
     */
    static List<Member> asked(Condition.Comparison comparison, Selection selection, @Nullable Member own) {
        Robots robots = comparison.robots();
        if (robots == null) {
            if (own == null) {
                throw new ScriptException(
                        comparison.parameter(),
                        comparison.parameter().text() + ": of which robot? Write its number in front");
            }
            return List.of(own);
        }
        List<Member> members = selection.members(robots);
        return robots.isAny() ? having(comparison, members) : members;
    }

    /** "Any" passes over robots that have no such parameter, as long as one has it. */
    private static List<Member> having(Condition.Comparison comparison, List<Member> members) {
        List<Member> able = members.stream()
                .filter(member -> has(member.bot(), comparison.parameter().text()))
                .toList();
        return able.isEmpty() ? members : able;
    }

    static boolean has(MajicBot bot, String parameter) {
        return bot.parameters().stream().anyMatch(known -> known.name().equalsIgnoreCase(parameter));
    }

    /** All robots that a condition reads, each once. */
    public static Set<Member> allAsked(Condition condition, Selection selection, @Nullable Member own) {
        Set<Member> members = new LinkedHashSet<>();
        condition.accept(new EachComparison(comparison -> members.addAll(asked(comparison, selection, own))));
        return members;
    }
}
