package majic.script.run;

import java.util.List;
import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.record.RecordedBlock;
import majic.script.record.SessionRecord;
import majic.script.syntax.Condition;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** A command for robots: how it is worded, checked, run, recorded and repeated. */
public interface Command extends Instruction {
    /** Where the command's own word stands. */
    Token at();

    /**
     * The words that answers repeat: without robots, MAJIC's own in lower case, names and numbers as they were written.
     */
    String text();

    /** The condition that ends a motion early; null for none. */
    default @Nullable Condition until() {
        return null;
    }

    @Override
    default Optional<String> refusalInAct() {
        return Optional.empty();
    }

    /** Further robots that it makes do something, as an act with several roles does; null for none. */
    default @Nullable Robots others() {
        return null;
    }

    /** The parameters that it reads or sets. */
    default List<Token> parameters() {
        return List.of();
    }

    /**
     * Checks whether one robot can do it; sends nothing. Each robot can unless this is overridden.
     *
     * @throws ScriptException if not
     */
    default void check(Check check) {}

    /**
     * Checks whether all robots of a line can do it; sends nothing.
     *
     * @param robots what each of them is checked against, at least one
     * @throws ScriptException if not
     */
    default void check(List<Check> robots) {
        robots.forEach(this::check);
    }

    /** Runs it on robots for which it was checked. */
    void run(Execution execution, List<Member> robots);

    /** Runs it as {@link #run} does, and records it if the execution is recorded. */
    default void perform(Execution execution, List<Member> robots) {
        SessionRecord record = execution.record();
        if (record == null) {
            run(execution, robots);
        } else {
            runRecorded(execution, robots, record, execution.block());
        }
    }

    /**
     * Runs it as {@link #run} does, and records it with the time at which it was submitted.
     *
     * @param block the block that the command stands in; null for a line of its own
     */
    default void runRecorded(
            Execution execution, List<Member> robots, SessionRecord record, @Nullable RecordedBlock block) {
        boolean commands = has(CommandTrait.COMMANDS_ROBOTS);
        if (commands && execution.isRecordedWhenBegun(number -> replayLine(execution, String.valueOf(number)))) {
            run(execution, robots);
            return;
        }
        SessionRecord.Event event = record.command(
                replayLine(execution, SessionRecord.names(SessionRecord.numbers(robots))),
                commands ? robots : List.of(),
                execution.owner(),
                block);
        run(execution, robots);
        record.keep(event);
    }

    /** The line with which a saved session repeats it for some robots; empty if there is nothing to repeat. */
    default String replayLine(Execution execution, String robots) {
        String text = replayText(execution);
        return text.isEmpty() ? "" : robots + " " + text;
    }

    /** The words of that line behind the robots; empty if there is nothing to repeat. */
    default String replayText(Execution execution) {
        return text();
    }

    /**
     * What a command for a robot is checked against. Its methods throw a {@link ScriptException} for what is wrong.
     *
     * @param session what the lines of the session share
     * @param selection finds the robots that conditions and roles name
     * @param robot the robot
     * @param limitMayChange whether {@code maxMove} may be another one when the command's turn comes; always true for a
     *     robot that is busy, since what it has queued is unknown here
     * @param readsFiles whether files may be read for the check, which may block
     */
    record Check(SessionState session, Selection selection, Member robot, boolean limitMayChange, boolean readsFiles) {
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
    }
}
