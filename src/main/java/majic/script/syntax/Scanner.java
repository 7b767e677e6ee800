package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.script.syntax.Token.Kind;

/** Makes tokens out of characters. Every text has tokens; the parser decides which of them form a line. */
public final class Scanner {
    private static final Pattern BLANK = Pattern.compile("[\\s\\x{FEFF}\\x{A0}]+");

    /** In the order in which they are tried. */
    private static final List<Form> FORMS = List.of(
            new Form(Kind.QUOTED, Pattern.compile("\"([^\"]*)\"")),
            new Form(Kind.SPAN, Pattern.compile("\\d+-\\d+(?![\\p{L}\\d]|\\.\\d)")),
            new Form(Kind.NUMBER, Pattern.compile("-?\\d+(\\.\\d+)?([\\p{L}%°][\\p{L}\\d%/²]*)?")),
            new Form(Kind.WORD, Pattern.compile("\\p{L}[\\p{L}\\d_]*(/[\\p{L}\\d_]+)*")),
            new Form(Kind.VARIABLE, Pattern.compile("-?\\$\\p{L}[\\p{L}\\d_]*")),
            new Form(Kind.OPERATOR, Pattern.compile("[<>=!]=|[<>=]")));

    private final String source;
    private final int line;
    private final List<Token> tokens;
    private int at;

    /** The characters of one kind of token; of a quoted text, the group is what stands between the quotes. */
    private record Form(Kind kind, Pattern pattern) {}

    private Scanner(String source, int line, List<Token> tokens) {
        this.source = source;
        this.line = line;
        this.tokens = tokens;
    }

    /** All tokens of a text, with a NEWLINE behind each line and an END at last. */
    public static List<Token> scan(String text) {
        List<Token> tokens = new ArrayList<>();
        String[] lines = text.split("\\R", -1);
        for (int index = 0; index < lines.length; index++) {
            new Scanner(lines[index], index + 1, tokens).scanLine();
        }
        int last = lines.length;
        int end = lines[last - 1].length() + 1;
        tokens.add(new Token(Kind.END, "", last, end, end, false));
        return tokens;
    }

    private void scanLine() {
        Matcher next = BLANK.matcher(source).useTransparentBounds(true);
        while (at < source.length() && source.charAt(at) != '#') {
            next.region(at, source.length());
            if (next.usePattern(BLANK).lookingAt()) {
                at = next.end();
            } else {
                scanToken(next);
            }
        }
        add(Kind.NEWLINE, "", at);
    }

    private void scanToken(Matcher next) {
        for (Form form : FORMS) {
            if (next.usePattern(form.pattern).lookingAt()) {
                int start = at;
                at = next.end();
                add(form.kind, form.kind == Kind.QUOTED ? next.group(1) : next.group(), start);
                return;
            }
        }
        takeSign();
    }

    private void takeSign() {
        int start = at;
        if (source.charAt(at) == '"') {
            at = source.length();
            add(Kind.OPEN_QUOTE, source.substring(start), start);
            return;
        }
        at += Character.charCount(source.codePointAt(at));
        String sign = source.substring(start, at);
        switch (sign) {
            case "," -> add(Kind.COMMA, sign, start);
            case "." -> add(Kind.DOT, sign, start);
            case "(" -> add(Kind.LEFT, sign, start);
            case ")" -> add(Kind.RIGHT, sign, start);
            default -> add(Kind.OTHER, sign, start);
        }
    }

    private void add(Kind kind, String text, int start) {
        tokens.add(new Token(kind, text, line, start + 1, at + 1, false));
    }
}
