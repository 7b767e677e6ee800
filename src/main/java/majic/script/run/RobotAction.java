package majic.script.run;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.syntax.Command;
import majic.script.syntax.CommandTrait;
import majic.script.syntax.Condition;
import majic.script.syntax.LineParser;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** How a command for robots is checked, run, recorded and repeated; one subclass for each kind of {@link Command}. */
public abstract class RobotAction {
    private final Command command;
    private final String text;

    public RobotAction(Command command) {
        this.command = command;
        this.text = command.text();
    }

    /** The words that answers repeat. */
    public final String text() {
        return text;
    }

    /**
     * Checks whether one robot can do it; sends nothing.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    public abstract void check(Check check);

    /**
     * Checks whether all robots of a line can do it; sends nothing.
     *
     * @param robots what each of them is checked against, at least one
     * @throws majic.script.syntax.ScriptException if not
     */
    public void check(List<Check> robots) {
        robots.forEach(this::check);
    }

    /** Runs it on robots for which it was checked. */
    public abstract void run(Execution execution, List<Member> robots);

    /**
     * Runs it as {@link #run} does, and records it with the time at which it was submitted.
     *
     * @param block the block that the command stands in; null for a line of its own
     */
    public void runRecorded(
            Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
        Set<Integer> numbers = SessionRecord.numbers(robots);
        boolean typed = execution.isTyped();
        if (command.has(CommandTrait.COMMANDS_ROBOTS)
                && execution.isRecordedWhenBegun(number -> replayLine(String.valueOf(number), typed))) {
            run(execution, robots);
            return;
        }
        SessionRecord.Event event = record.command(
                replayLine(SessionRecord.names(numbers), typed),
                command.has(CommandTrait.COMMANDS_ROBOTS) ? numbers : Set.of(),
                execution.owner(),
                block);
        run(execution, robots);
        record.keep(event);
    }

    /** The line with which a saved session repeats it for some robots; empty if there is nothing to repeat. */
    public String replayLine(String robots, boolean typed) {
        String text = replayText(typed);
        return text.isEmpty() ? "" : robots + " " + text;
    }

    /** The words of that line behind the robots; empty if there is nothing to repeat. */
    public String replayText(boolean typed) {
        return text();
    }

    /**
     * What a command for a robot is checked against. Its methods throw a {@link ScriptException} for what is wrong.
     *
     * @param selection finds the robots that conditions and roles name
     * @param robot the robot
     * @param limitMayChange whether {@code maxMove} may be another one when the command's turn comes; always true for a
     *     robot that is busy, since what it has queued is unknown here
     * @param readsFiles whether files may be read for the check, which may block
     */
    public record Check(Selection selection, Member robot, boolean limitMayChange, boolean readsFiles) {
        public Check {
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
}
