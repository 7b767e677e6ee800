package majic.script;

/**
 * One line that message area, console and session log all show, the same everywhere. Immutable.
 *
 * @param kind what it is
 * @param text without line break
 */
public record Line(Kind kind, String text) {
    /** What a line can be. */
    public enum Kind {
        /** A line as it was given to MAJIC. */
        COMMAND,
        /** What became of a command, well or not. */
        ANSWER,
        /** Something a robot or MAJIC says unasked. */
        NOTICE,
        /** Why a line was refused or a script ended, or what went wrong in MAJIC itself. */
        ERROR
    }
}
