package majic.script.run;

import java.util.Set;
import majic.script.conditions.Selection;

/**
 * How a command for the session is scheduled, checked and run; one subclass for each kind of
 * {@link majic.script.syntax.SessionCommand}.
 */
public abstract class SessionAction {
    private final Scheduling scheduling;
    private final Set<CommandTrait> traits;

    public SessionAction(Scheduling scheduling, CommandTrait... traits) {
        this.scheduling = scheduling;
        this.traits = Set.of(traits);
    }

    public final Scheduling scheduling() {
        return scheduling;
    }

    public final Set<CommandTrait> traits() {
        return traits;
    }

    public final boolean has(CommandTrait trait) {
        return traits.contains(trait);
    }

    /**
     * Checks whether it can be done; changes nothing.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    public abstract void check(Check check);

    /** Runs it. */
    public abstract void run(Execution execution);

    /**
     * What a command for the session is checked against.
     *
     * @param selection finds the robots it names
     * @param filesMayAppear whether an earlier command of the same script writes files
     */
    public record Check(Selection selection, boolean filesMayAppear) {}
}
