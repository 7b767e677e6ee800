package majicsim.aibo.urbi.syntax;

import java.util.Map;

/** One word or sign of a command: its text, its value if it is a number, and where it stands. */
record Token(TokenKind kind, String text, double number, Span span) {
    private static final Map<String, String> TITLES = Map.of(
            "'", "derivation",
            "''", "second-derivation",
            "'n", "normalized",
            "'d", "command-derivation",
            "'dd", "second-command-derivation",
            "list", "group list");

    boolean is(String wanted) {
        return (kind == TokenKind.SYMBOL || kind == TokenKind.WORD || kind == TokenKind.SWITCH) && text.equals(wanted);
    }

    boolean is(TokenKind wanted) {
        return kind == wanted;
    }

    /** Its name in a syntax error. */
    String title() {
        return kind.title().isEmpty() ? TITLES.getOrDefault(text, text) : kind.title();
    }
}
