package majic.script.syntax;

/**
 * The smallest piece of a script, with its place. Immutable.
 *
 * @param kind what it is
 * @param text as it was written; without the quotes if it was quoted
 * @param line counted from 1
 * @param column of its first character, counted from 1
 * @param end the column behind its last character
 */
public record Token(Kind kind, String text, int line, int column, int end) {
    /** What a token can be. */
    public enum Kind {
        /** A number with or without a unit: {@code -3}, {@code 2.5m}. */
        NUMBER,
        /** Two whole numbers with a dash between them: {@code 1-4}. */
        SPAN,
        /** A letter, then letters and digits. */
        WORD,
        /** Text in quotes. */
        QUOTED,
        /** A quote that is never closed, to the end of its line. */
        OPEN_QUOTE,
        COMMA,
        DOT,
        LEFT,
        RIGHT,
        /** One of {@code < <= > >= == != =}. */
        OPERATOR,
        /** A character that means nothing by itself, but may stand in an address or a file's name. */
        OTHER,
        /** The end of a line. */
        NEWLINE,
        /** The end of all. */
        END
    }

    public boolean is(String word) {
        return kind == Kind.WORD && text.equalsIgnoreCase(word);
    }

    public boolean isEnd() {
        return kind == Kind.NEWLINE || kind == Kind.END;
    }

    /** Whether another token follows this one with nothing between them. */
    boolean touches(Token next) {
        return next.line == line && next.column == end && !next.isEnd();
    }

    /** As it was written, quotes included. */
    public String written() {
        return kind == Kind.QUOTED ? '"' + text + '"' : text;
    }
}
