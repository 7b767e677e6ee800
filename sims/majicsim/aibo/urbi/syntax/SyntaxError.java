package majicsim.aibo.urbi.syntax;

/** A syntax error; its message is the kernel's, without the position. */
final class SyntaxError extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Span span;
    private final boolean afterCommand;

    SyntaxError(Span span, String message, boolean afterCommand) {
        super(message);
        this.span = span;
        this.afterCommand = afterCommand;
    }

    static SyntaxError unexpected(Token token) {
        return new SyntaxError(token.span(), "syntax error, unexpected " + token.title(), false);
    }

    static SyntaxError unexpected(Token token, String expected) {
        return new SyntaxError(
                token.span(), "syntax error, unexpected " + token.title() + ", expecting " + expected, false);
    }

    /** Something stands behind a complete command; then the kernel goes on counting lines from there. */
    static SyntaxError expectedEnd(Token token, boolean afterCommand) {
        return new SyntaxError(
                token.span(), "syntax error, unexpected " + token.title() + ", expecting end of command", afterCommand);
    }

    Span span() {
        return span;
    }

    boolean afterCommand() {
        return afterCommand;
    }
}
