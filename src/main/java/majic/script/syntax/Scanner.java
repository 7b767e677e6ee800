package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.script.syntax.Token.Kind;
import org.jspecify.annotations.Nullable;

/** Makes tokens out of characters. Every text has tokens; what they are worth is the parser's business. */
public final class Scanner {
    private static final Pattern BLANK = Pattern.compile("[\\s\\x{FEFF}\\x{A0}]+");
    private static final Pattern SPAN = Pattern.compile("\\d+-\\d+(?![\\p{L}\\d]|\\.\\d)");
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?([\\p{L}%°][\\p{L}\\d%/²]*)?");
    private static final Pattern WORD = Pattern.compile("\\p{L}[\\p{L}\\d_]*(/[\\p{L}\\d_]+)*");
    private static final Pattern VARIABLE = Pattern.compile("-?\\$\\p{L}[\\p{L}\\d_]*");
    private static final Pattern QUOTED = Pattern.compile("\"([^\"]*)\"");
    private static final Pattern OPERATOR = Pattern.compile("[<>=!]=|[<>=]");

    private final String source;
    private final int line;
    private final List<Token> tokens;
    private int at;

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
        tokens.add(new Token(Kind.END, "", last, end, end));
        return tokens;
    }

    private void scanLine() {
        while (at < source.length() && source.charAt(at) != '#') {
            scanToken();
        }
        add(Kind.NEWLINE, "", at);
    }

    private void scanToken() {
        if (matches(BLANK) != null) {
            return;
        }
        int start = at;
        Matcher quoted = matches(QUOTED);
        if (quoted != null) {
            add(Kind.QUOTED, quoted.group(1), start);
        } else if (!take(Kind.SPAN, SPAN)
                && !take(Kind.NUMBER, NUMBER)
                && !take(Kind.WORD, WORD)
                && !take(Kind.VARIABLE, VARIABLE)
                && !take(Kind.OPERATOR, OPERATOR)) {
            takeSign();
        }
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

    private boolean take(Kind kind, Pattern pattern) {
        int start = at;
        Matcher found = matches(pattern);
        if (found == null) {
            return false;
        }
        add(kind, found.group(), start);
        return true;
    }

    private @Nullable Matcher matches(Pattern pattern) {
        Matcher matcher = pattern.matcher(source).region(at, source.length());
        matcher.useTransparentBounds(true);
        if (!matcher.lookingAt()) {
            return null;
        }
        at = matcher.end();
        return matcher;
    }

    private void add(Kind kind, String text, int start) {
        tokens.add(new Token(kind, text, line, start + 1, at + 1));
    }
}
