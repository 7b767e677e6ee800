package majic.log;

import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * One line that message area, console and session log all show, the same everywhere. Immutable.
 *
 * @param kind what it is
 * @param text one line; line ends and control characters in it are made visible
 * @param asker the parser whose line it repeats or answers; null if it concerns all
 */
public record Line(Kind kind, String text, @Nullable Object asker) {
    /** Makes a text of any origin safe to show. */
    public Line {
        text = VisibleText.of(text);
    }

    /**
     * A line that concerns all.
     *
     * @param kind what it is
     * @param text without line break
     */
    public Line(Kind kind, String text) {
        this(kind, text, null);
    }

    /**
     * Whether it is to be shown to the source of lines that a parser has.
     *
     * @param source the parser of one place where lines come from
     * @return false only if it answers another parser's line
     */
    public boolean concerns(Object source) {
        return asker == null || asker == source;
    }

    /** What a line can be. */
    public enum Kind {
        /** A line as it was given to MAJIC. */
        COMMAND,
        /** What became of a command, well or not. */
        ANSWER,
        /** Something a robot or MAJIC reports unasked. */
        NOTICE,
        /** Why a line was refused or a script ended, or what went wrong in MAJIC itself. */
        ERROR
    }
}
