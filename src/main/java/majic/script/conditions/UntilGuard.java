package majic.script.conditions;

import java.util.List;
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

    /**
     * The guard of a motion.
     *
     * @param own the robot that moves
     * @throws ScriptException if a robot that the condition names is not there
     */
    public UntilGuard(Condition condition, Selection selection, Member own) {
        this.condition = condition;
        this.readings = new ConditionEvaluator(selection, own);
        this.others = ConditionEvaluator.allAsked(condition, selection, own).stream()
                .filter(member -> member != own)
                .map(Member::bot)
                .toList();
    }

    @Override
    public boolean reached() {
        try {
            Truth truth = condition.accept(readings);
            if (truth.undecided() != null) {
                throw new BotException("until cannot be told: " + truth.undecided());
            }
            return truth.holds();
        } catch (ScriptException e) {
            throw new BotException("until cannot be told: " + e.getMessage(), e);
        }
    }

    @Override
    public List<MajicBot> alsoWatches() {
        return others;
    }
}
