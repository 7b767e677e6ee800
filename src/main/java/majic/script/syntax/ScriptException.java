package majic.script.syntax;

import java.util.function.Supplier;
import majic.bot.BotException;

/** A mistake in a script, with its place. The message is one sentence: what is wrong and what would be right. */
public final class ScriptException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Token at;

    public ScriptException(Token at, String message) {
        super(message);
        this.at = at;
    }

    /**
     * Does something that may go wrong because of what stands at a place.
     *
     * @throws ScriptException if it does, with the same sentence
     */
    public static void placed(Token at, Runnable check) {
        placed(at, () -> {
            check.run();
            return true;
        });
    }

    /** As {@link #placed(Token, Runnable)}, for something that has a result. */
    public static <T> T placed(Token at, Supplier<T> found) {
        try {
            return found.get();
        } catch (BotException e) {
            throw new ScriptException(at, String.valueOf(e.getMessage()));
        }
    }

    public Token at() {
        return at;
    }

    public Mistake mistake() {
        return new Mistake(at.line(), at.column(), String.valueOf(getMessage()));
    }
}
