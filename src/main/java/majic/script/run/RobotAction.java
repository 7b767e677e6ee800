package majic.script.run;

import java.util.List;
import java.util.Set;
import majic.script.conditions.Selection;
import majic.script.record.RecordedBlock;
import majic.script.record.RecordedEvent;
import majic.script.record.SessionRecord;
import majic.script.syntax.Command;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** How a command for robots is scheduled, checked, run, recorded and repeated; one subclass for each kind of {@link Command}. */
public abstract class RobotAction {
    private final Command command;
    private final Scheduling scheduling;
    private final Set<CommandTrait> traits;

    public RobotAction(Command command, Scheduling scheduling, CommandTrait... traits) {
        this.command = command;
        this.scheduling = scheduling;
        this.traits = Set.of(traits);
    }

    public final Scheduling scheduling() {
        return scheduling;
    }

    public final Set<CommandTrait> traits() {
        return traits;
    }

    final boolean has(CommandTrait trait) {
        return traits.contains(trait);
    }

    /** The words that answers repeat. */
    public final String text() {
        return command.text();
    }

    /**
     * Checks whether one robot can do it; sends nothing.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    public abstract void check(RobotCheck check);

    /** Further robots that it makes do something, as far as they are there; none for most commands. */
    public List<Member> others(Selection selection) {
        return List.of();
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
        String text = replayText(execution.isTyped());
        RecordedEvent event = record.command(
                text.isEmpty() ? "" : RecordedEvent.names(numbers) + " " + text,
                has(CommandTrait.COMMANDS_ROBOTS) ? numbers : Set.of(),
                execution.owner(),
                block);
        run(execution, robots);
        record.keep(event);
    }

    /** The words with which a saved session repeats it; empty if there is nothing to repeat. */
    public String replayText(boolean typed) {
        return text();
    }
}
