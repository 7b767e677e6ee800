package majic.log;

import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * One line of the session, shown in the same form by message area, console and session log. Immutable.
 *
 * @param kind the kind of line
 * @param text one line; line ends and control characters in it are made visible
 * @param asker the parser whose line it repeats or answers; null if it concerns all
 */
public record Line(Kind kind, String text, @Nullable Object asker) {
    /** Makes line ends and control characters of the text visible. */
    public Line {
        text = VisibleText.of(text);
    }

    /**
     * Creates a line that concerns all.
     *
     * @param kind what it is
     * @param text without line break
     */
    public Line(Kind kind, String text) {
        this(kind, text, null);
    }

    /**
     * Returns whether the line is to be shown at the source of lines that belongs to a parser.
     *
     * @param source the parser of one place where lines come from
     * @return false only if it answers another parser's line
     */
    public boolean concerns(Object source) {
        return asker == null || asker == source;
    }

    /** The kinds of lines. */
    public enum Kind {
        /** A line as it was submitted to MAJIC. */
        COMMAND,
        /** The result of a command that did not fail. */
        ANSWER,
        /** The result of a command that failed. */
        FAILURE,
        /** An unsolicited message from a robot or from MAJIC. */
        NOTICE,
        /** A lost connection, or a stop that a robot did not confirm: the robot may be moving. */
        ALARM,
        /** The reason why a line was refused or a script ended, or an internal error of MAJIC. */
        ERROR
    }
}
