package majic.script.syntax;

/** A mistake in a script, with its place. The message is one sentence: what is wrong and what would be right. */
public final class ScriptException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Token at;
    private final String expected;

    public ScriptException(Token at, String message) {
        this(at, message, "");
    }

    ScriptException(Token at, String message, String expected) {
        super(message);
        this.at = at;
        this.expected = expected;
    }

    public Token at() {
        return at;
    }

    /** What the grammar expects at the place, as in "a distance (mm, cm, m)"; empty if the mistake is another one. */
    public String expected() {
        return expected;
    }

    public Mistake mistake() {
        return new Mistake(at.line(), at.column(), String.valueOf(getMessage()));
    }
}
