package majic.script.run;

import java.util.Optional;
import majic.script.conditions.Selection;

/** A command for the session as a whole: how it is checked and run. Immutable. */
public interface SessionCommand extends Instruction {
    /** Why a behaviour may contain hardly any of them. */
    Optional<String> REFUSED_IN_ACT = Optional.of("is for a session; an act only commands the robots it is given");

    @Override
    default Optional<String> refusalInAct() {
        return REFUSED_IN_ACT;
    }

    /**
     * Checks whether it can be done; changes nothing. It always can unless this is overridden.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    default void check(Check check) {}

    /** Runs it; blocks until it has ended. */
    void run(Execution execution);

    /**
     * What a command for the session is checked against.
     *
     * @param session what the lines of the session share
     * @param selection finds the robots it names
     * @param filesMayAppear whether an earlier command of the same script writes files
     */
    record Check(SessionState session, Selection selection, boolean filesMayAppear) {}
}
