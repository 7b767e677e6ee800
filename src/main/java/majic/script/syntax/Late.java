package majic.script.syntax;

import java.util.List;
import java.util.function.Function;

/**
 * A piece of a script that may have values in it which are known only when it runs: its grammar rule is applied again
 * each time, with the values of that moment. A piece without such values is parsed once. Immutable.
 *
 * @param <T> what the rule makes of it
 */
public final class Late<T> {
    private final T sample;
    private final boolean open;
    private final List<Cursor.Reading> readings;
    private final List<Token> tokens;
    private final int start;
    private final Function<Cursor, T> rule;

    private Late(
            T sample,
            boolean open,
            List<Cursor.Reading> readings,
            List<Token> tokens,
            int start,
            Function<Cursor, T> rule) {
        this.sample = sample;
        this.open = open;
        this.readings = readings;
        this.tokens = tokens;
        this.start = start;
        this.rule = rule;
    }

    /** A piece that is known. */
    public static <T> Late<T> of(T known) {
        return new Late<>(known, false, List.of(), List.of(), 0, at -> known);
    }

    /** What a function makes of the piece, each time. */
    public <R> Late<R> map(Function<T, R> function) {
        return new Late<>(function.apply(sample), open, readings, tokens, start, rule.andThen(function));
    }

    /** Parses a piece where a cursor is, and moves the cursor behind it; throws what the rule throws. */
    public static <T> Late<T> parse(Cursor at, Function<Cursor, T> rule) {
        int start = at.place();
        return again(at, start, rule.apply(at), rule);
    }

    /**
     * A piece that a cursor has just parsed.
     *
     * @param start the place of its first token
     * @param parsed what came of it
     * @param rule parses it again
     */
    public static <T> Late<T> again(Cursor behind, int start, T parsed, Function<Cursor, T> rule) {
        return new Late<>(parsed, behind.isOpenSince(start), behind.readingsSince(start), behind.tokens(), start, rule);
    }

    /** The piece as far as it was known when it was parsed: a value that was not is a sample of its kind. */
    public T sample() {
        return sample;
    }

    /** The readings that its values are computed of. */
    public List<Cursor.Reading> readings() {
        return readings;
    }

    /**
     * The piece with the values of this moment.
     *
     * @throws ScriptException at a value that cannot be had, or that does not fit
     */
    public T with(Values values) {
        return open ? rule.apply(new Cursor(tokens, start, values)) : sample;
    }
}
