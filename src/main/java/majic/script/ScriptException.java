package majic.script;

/** A mistake in a script, with its place. The message is one sentence: what is wrong and what would be right. */
final class ScriptException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Token at;

    ScriptException(Token at, String message) {
        super(message);
        this.at = at;
    }

    Token at() {
        return at;
    }

    Mistake mistake() {
        return new Mistake(at.line(), at.column(), String.valueOf(getMessage()));
    }
}
