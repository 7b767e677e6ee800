package majic.shared.desk;

import majic.bot.BotException;
import majic.bot.Guard;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.conditions.UntilGuard;
import majic.script.syntax.Condition;
import majic.script.syntax.ConditionParser;
import majic.script.syntax.ScriptException;
import majic.team.Member;
import majic.team.Team;
import majic.text.VisibleText;

/** Makes the guard of a motion from the text of its condition, for evaluation where the robot is. */
final class UntilText {
    private static final int LONGEST = 1000;

    private UntilText() {}

    /**
     * Returns the guard.
     *
     * @param text MAJIC Script; empty for none
     * @param member the robot that moves, whose parameters are meant where no robot is named
     * @throws BotException if it is not a condition, or does not fit the robots
     */
    static Guard guard(String text, Team team, Member member) {
        if (text.isEmpty()) {
            return Guard.NEVER;
        }
        String shown = VisibleText.of(text);
        if (text.length() > LONGEST || !shown.equals(text)) {
            throw new BotException("until: a condition is one line of at most " + LONGEST + " characters");
        }
        try {
            Selection selection = new Selection(team);
            Condition condition = ConditionParser.parse(text);
            Comparisons.check(condition, selection, member);
            return new UntilGuard(condition, selection, member);
        } catch (ScriptException e) {
            throw new BotException("until " + shown + ": " + e.getMessage(), e);
        }
    }
}
