package majic.script.syntax;

import java.util.Collection;
import java.util.Locale;
import java.util.function.Supplier;
import majic.bot.BotException;

/**
 * The smallest piece of a script, with its place. Immutable.
 *
 * @param kind what it is
 * @param text as it was written; without the quotes if it was quoted
 * @param line counted from 1
 * @param column of its first character, counted from 1
 * @param end the column behind its last character
 * @param open whether the text is only a sample of a value that is known when the line runs
 */
public record Token(Kind kind, String text, int line, int column, int end, boolean open) {
    public Token(Kind kind, String text, int line, int column, int end) {
        this(kind, text, line, column, end, false);
    }

    /** What a token can be. */
    public enum Kind {
        /** A number with or without a unit: {@code -3}, {@code 2.5m}. */
        NUMBER,
        /** Two whole numbers with a dash between them: {@code 1-4}. */
        SPAN,
        /** A letter, then letters and digits. */
        WORD,
        /** A name that stands for a value: {@code $speed}, {@code -$speed}. */
        VARIABLE,
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

    /** Whether it is one of some words, which are in lower case. */
    public boolean isOneOf(Collection<String> words) {
        return kind == Kind.WORD && words.contains(text.toLowerCase(Locale.ROOT));
    }

    public boolean isEnd() {
        return kind == Kind.NEWLINE || kind == Kind.END;
    }

    /** Whether another token follows this one with nothing between them. */
    boolean touches(Token next) {
        return next.line == line && next.column == end && !next.isEnd();
    }

    /**
     * Runs a check of what stands here.
     *
     * @throws ScriptException with the message of the check, placed here, if the check throws a {@link BotException}
     */
    public void check(Runnable check) {
        resolve(() -> {
            check.run();
            return true;
        });
    }

    /** Looks up what stands here; throws as {@link #check} does. */
    public <T> T resolve(Supplier<T> lookup) {
        try {
            return lookup.get();
        } catch (BotException e) {
            throw new ScriptException(this, String.valueOf(e.getMessage()));
        }
    }

    /** As it was written, quotes included. */
    public String written() {
        return kind == Kind.QUOTED ? '"' + text + '"' : text;
    }
}
