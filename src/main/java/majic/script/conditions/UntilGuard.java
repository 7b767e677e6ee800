package majic.script.conditions;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.script.syntax.Condition;
import majic.script.syntax.ScriptException;
import majic.team.Member;

/** The condition behind {@code until}, as a driver evaluates it. */
public final class UntilGuard implements Guard {
    private final Condition condition;
    private final ConditionEvaluator readings;
    private final List<MajicBot> others;
    private final boolean readsOwnOnly;

    /**
     * The guard of a motion.
     *
     * @param own the robot that moves
     * @throws ScriptException if a robot that the condition names is not there
     */
    public UntilGuard(Condition condition, Selection selection, Member own) {
        this.condition = condition;
        this.readings = new ConditionEvaluator(selection, own);
        Set<Member> asked = ConditionEvaluator.allAsked(condition, selection, own);
        this.readsOwnOnly = asked.equals(Set.of(own));
        this.others =
                asked.stream().filter(member -> member != own).map(Member::bot).toList();
    }

    @Override
    public boolean reached() {
        try {
            Truth truth = condition.accept(readings);
            if (truth.undecided() != null) {
                throw new BotException("until is undecided: " + truth.undecided());
            }
            return truth.holds();
        } catch (ScriptException e) {
            throw new BotException("until is undecided: " + e.getMessage(), e);
        }
    }

    @Override
    public List<MajicBot> alsoWatches() {
        return others;
    }

    @Override
    public Optional<String> text() {
        return readsOwnOnly ? Optional.of(condition.accept(new WithoutRobots()).toString()) : Optional.empty();
    }

    /** The same condition for another team, in which the robot that moves has another number. */
    private static final class WithoutRobots implements Condition.Visitor<Condition> {
        @Override
        public Condition or(Condition.Or or) {
            return new Condition.Or(or.left().accept(this), or.right().accept(this));
        }

        @Override
        public Condition and(Condition.And and) {
            return new Condition.And(and.left().accept(this), and.right().accept(this));
        }

        @Override
        public Condition not(Condition.Not not) {
            return new Condition.Not(not.inner().accept(this));
        }

        @Override
        public Condition comparison(Condition.Comparison comparison) {
            return new Condition.Comparison(null, comparison.parameter(), comparison.operator(), comparison.value());
        }

        @Override
        public Condition known(Condition.Known known) {
            return known;
        }
    }
}
