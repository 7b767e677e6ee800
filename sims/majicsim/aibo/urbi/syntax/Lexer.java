package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majicsim.aibo.urbi.value.Value;

/** Turns the text of one command into tokens (URBI sheet, sections 3 and 5). */
final class Lexer {
    private static final Pattern FLAG =
            Pattern.compile("\\+(begin|end|report|error|bg|connection|timeout|stop|freeze)\\b");
    private static final Pattern NUMBER = Pattern.compile("\\d++(?:\\.\\d++)?|\\.\\d++");
    private static final Pattern TIME = Pattern.compile(
            "(?:(#)d)?(?:(#)h)?(?:(#)m(?!s))?(?:(#)s)?(?:(#)ms)?(?!\\w)".replace("#", NUMBER.pattern()));
    private static final double[] UNIT_MS = {86_400_000, 3_600_000, 60_000, 1000, 1};
    private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*+(?:\\.[A-Za-z_]\\w*+)?");
    private static final Pattern SUFFIX = Pattern.compile("'(?:in|out|dd|n|d|e)\\b|''|'");
    private static final Pattern SYMBOL =
            Pattern.compile("=~=|==|!=|~=|%=|<=|>=|&&|\\|\\||\\+\\+|--|\\+=|-=|->|::|[-+*/%^=<>!&|~:;,(){}\\[\\].$@]");
    private static final Set<String> WORDS = Set.of(
            "addgroup",
            "alias",
            "at",
            "bin",
            "block",
            "class",
            "copy",
            "def",
            "delete",
            "delgroup",
            "echo",
            "else",
            "emit",
            "event",
            "every",
            "for",
            "foreach",
            "freeze",
            "freezeif",
            "function",
            "group",
            "if",
            "in",
            "info",
            "list",
            "loop",
            "loopn",
            "new",
            "noop",
            "onleave",
            "return",
            "static",
            "stop",
            "stopif",
            "timeout",
            "unalias",
            "unblock",
            "undef",
            "unfreeze",
            "var",
            "wait",
            "waituntil",
            "whenever",
            "while");
    private static final Map<String, Double> CONSTANTS =
            Map.of("on", 1.0, "off", 0.0, "true", 1.0, "false", 0.0, "pi", Math.PI, "inf", Value.INFINITY);

    private final String text;
    private final BiConsumer<Span, String> errors;
    private final List<Token> tokens = new ArrayList<>();
    private int at;
    private Place place;

    /**
     * @param start where the text begins in the connection's program
     * @param errors takes the position and the text of each character that no token begins with; it is left out
     */
    Lexer(String text, Place start, BiConsumer<Span, String> errors) {
        this.text = text;
        this.place = start;
        this.errors = errors;
    }

    /** All tokens, the last of kind END. */
    List<Token> tokens() {
        skipBlank();
        while (at < text.length()) {
            next();
            skipBlank();
        }
        tokens.add(new Token(TokenKind.END, "", 0, new Span(place, place)));
        return List.copyOf(tokens);
    }

    /** Where the program goes on behind this text. */
    Place end() {
        return place;
    }

    private void next() {
        char c = text.charAt(at);
        if (c == '"') {
            string();
        } else if (isDigit(at) || (c == '.' && isDigit(at + 1))) {
            number();
        } else if (isLetter(c)) {
            name();
        } else if (!match(FLAG, TokenKind.FLAG)
                && !match(SUFFIX, TokenKind.SYMBOL)
                && !match(SYMBOL, TokenKind.SYMBOL)) {
            Place first = place;
            advance(1);
            errors.accept(new Span(first, first), "invalid character: " + (c == 0 ? "" : c));
        }
    }

    private void skipBlank() {
        while (at < text.length()) {
            if (" \t\r\n".indexOf(text.charAt(at)) >= 0) {
                advance(1);
            } else if (text.startsWith("//", at) || text.charAt(at) == '#') {
                advance(upTo("\n"));
            } else if (text.startsWith("/*", at)) {
                advance(upTo("*/"));
            } else {
                return;
            }
        }
    }

    private int upTo(String end) {
        int found = text.indexOf(end, at + 1);
        return (found < 0 ? text.length() : found + end.length()) - at;
    }

    private void string() {
        int end = at + 1;
        while (end < text.length() && text.charAt(end) != '"') {
            end += text.charAt(end) == '\\' ? 2 : 1;
        }
        end = Math.min(end, text.length() - 1);
        add(TokenKind.STRING, text.substring(at + 1, Math.max(at + 1, end)), 0, end + 1 - at);
    }

    private void number() {
        Matcher time = matcher(TIME);
        if (time.lookingAt() && time.end() > at) {
            double ms = 0;
            for (int i = 0; i < UNIT_MS.length; i++) {
                ms += time.group(i + 1) == null ? 0 : Double.parseDouble(time.group(i + 1)) * UNIT_MS[i];
            }
            add(TokenKind.TIME, time.group(), ms, time.end() - at);
            return;
        }
        Matcher plain = matcher(NUMBER);
        if (plain.lookingAt()) {
            add(TokenKind.NUMBER, plain.group(), Double.parseDouble(plain.group()), plain.end() - at);
        }
    }

    private void name() {
        Matcher matcher = matcher(NAME);
        if (!matcher.lookingAt()) {
            return;
        }
        String name = matcher.group();
        Double constant = CONSTANTS.get(name);
        TokenKind kind = TokenKind.IDENTIFIER;
        if (constant != null) {
            kind = TokenKind.NUMBER;
        } else if (name.equals("switch")) {
            kind = TokenKind.SWITCH;
        } else if (WORDS.contains(name) || name.equals("BIN")) {
            kind = TokenKind.WORD;
        } else if (name.indexOf('.') >= 0) {
            kind = TokenKind.STRUCTURED;
        }
        add(kind, name.equals("BIN") ? "bin" : name, constant == null ? 0 : constant, name.length());
    }

    private boolean match(Pattern pattern, TokenKind kind) {
        Matcher matcher = matcher(pattern);
        if (!matcher.lookingAt()) {
            return false;
        }
        add(kind, matcher.group(), 0, matcher.end() - at);
        return true;
    }

    private Matcher matcher(Pattern pattern) {
        return pattern.matcher(text).region(at, text.length());
    }

    private void add(TokenKind kind, String word, double number, int length) {
        Place first = place;
        advance(length - 1);
        Place last = place;
        advance(1);
        tokens.add(new Token(kind, word, number, new Span(first, last)));
    }

    private void advance(int count) {
        for (int i = 0; i < count; i++) {
            place = place.after(text.charAt(at++));
        }
    }

    private boolean isDigit(int index) {
        return index < text.length() && text.charAt(index) >= '0' && text.charAt(index) <= '9';
    }

    private static boolean isLetter(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    }
}
