package majic.script.run;

import java.util.List;
import java.util.Set;
import majic.script.syntax.Command;
import majic.team.Member;

/** How a command for robots is scheduled, checked, run and repeated; one subclass for each kind of {@link Command}. */
public abstract class RobotAction {
    private final Command command;
    private final Scheduling scheduling;
    private final Set<Trait> traits;

    public RobotAction(Command command, Scheduling scheduling, Trait... traits) {
        this.command = command;
        this.scheduling = scheduling;
        this.traits = Set.of(traits);
    }

    public final Scheduling scheduling() {
        return scheduling;
    }

    public final Set<Trait> traits() {
        return traits;
    }

    final boolean has(Trait trait) {
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

    /** Runs it on robots for which it was checked. */
    public abstract void run(Execution execution, List<Member> robots);

    /** The words with which a saved session repeats it; empty if there is nothing to repeat. */
    public String replayText(boolean typed) {
        return text();
    }
}
