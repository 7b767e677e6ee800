package majic.script.syntax;

/** A mistake in a script, with its place. The message is one sentence: what is wrong and what would be right. */
public final class ScriptException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Token at;

    public ScriptException(Token at, String message) {
        super(message);
        this.at = at;
    }

    public Token at() {
        return at;
    }

    public Mistake mistake() {
        return new Mistake(at.line(), at.column(), String.valueOf(getMessage()));
    }
}
