package majic.script;

import java.util.Set;

/**
 * How a command for the session is scheduled, checked and run; one subclass for each kind of
 * {@link majic.script.syntax.SessionCommand}.
 */
abstract class SessionAction {
    private final Scheduling scheduling;
    private final Set<Trait> traits;

    SessionAction(Scheduling scheduling, Trait... traits) {
        this.scheduling = scheduling;
        this.traits = Set.of(traits);
    }

    final Scheduling scheduling() {
        return scheduling;
    }

    final Set<Trait> traits() {
        return traits;
    }

    final boolean has(Trait trait) {
        return traits.contains(trait);
    }

    /**
     * Checks whether it can be done; changes nothing.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    abstract void check(SessionCheck check);

    /** Runs it. */
    abstract void run(Execution execution);
}
