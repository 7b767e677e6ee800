package majic.script.run;

import java.util.Locale;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.syntax.Condition;
import majic.script.syntax.LineParser;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * What a command for a robot is checked against. Its methods throw a {@link ScriptException} for what is wrong.
 *
 * @param selection finds the robots that conditions and roles name
 * @param robot the robot
 * @param limitMayChange whether {@code maxMove} may be another one when the command's turn comes; always true for a robot
 *     that is busy, since what it has queued is unknown here
 * @param readsFiles whether files may be read for the check, which may block
 */
public record RobotCheck(Selection selection, Member robot, boolean limitMayChange, boolean readsFiles) {
    public RobotCheck {
        limitMayChange |= !robot.isIdle();
    }

    public MajicBot bot() {
        return robot.bot();
    }

    public void until(@Nullable Condition condition) {
        if (condition != null) {
            Comparisons.check(condition, selection, robot);
        }
    }

    public Parameter parameter(Token name) {
        return name.resolve(() -> bot().parameter(name.text()));
    }

    public void readable(Token name) {
        if (!parameter(name).readable()) {
            throw new ScriptException(name, name.text() + ": can be set but not read");
        }
    }

    /** Whether the robot has a command of that name. */
    public boolean isCommand(String word) {
        return LineParser.COMMAND_WORDS.contains(word.toLowerCase(Locale.ROOT))
                || bot().commands().stream().anyMatch(own -> own.name().equalsIgnoreCase(word));
    }
}
