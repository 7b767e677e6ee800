package majicsim.aibo.urbi.syntax;

/** What a token is, with the name by which the kernel's syntax errors call it. */
enum TokenKind {
    IDENTIFIER("identifier"),
    STRUCTURED("structured identifier"),
    NUMBER("number"),
    TIME("time"),
    STRING("string"),
    FLAG("flag"),
    SWITCH("switch"),
    WORD(""),
    SYMBOL(""),
    END("end of command");

    private final String title;

    TokenKind(String title) {
        this.title = title;
    }

    String title() {
        return title;
    }
}
