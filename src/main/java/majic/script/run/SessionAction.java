package majic.script.run;

import majic.script.conditions.Selection;

/**
 * How a command for the session is checked and run; one subclass for each kind of
 * {@link majic.script.syntax.SessionCommand}.
 */
public interface SessionAction {
    /**
     * Checks whether it can be done; changes nothing.
     *
     * @throws majic.script.syntax.ScriptException if not
     */
    void check(Check check);

    /** Runs it. */
    void run(Execution execution);

    /**
     * What a command for the session is checked against.
     *
     * @param selection finds the robots it names
     * @param filesMayAppear whether an earlier command of the same script writes files
     */
    record Check(Selection selection, boolean filesMayAppear) {}
}
