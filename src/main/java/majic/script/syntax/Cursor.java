package majic.script.syntax;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majic.bot.Value;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Token.Kind;

/** A place in a list of tokens that moves forward: the four helpers that every grammar rule is written with. */
public final class Cursor {
    private final List<Token> tokens;
    private Map<String, Value> variables = Map.of();
    private int next;

    /** The last token is an END. */
    public Cursor(List<Token> tokens) {
        this.tokens = tokens;
    }

    /**
     * Lets a name stand for a value from now on: {@code $name}.
     *
     * @param name in lower case
     */
    public void define(String name, Value value) {
        if (variables.isEmpty()) {
            variables = new HashMap<>();
        }
        variables.put(name, value);
    }

    public boolean isDefined(String name) {
        return variables.containsKey(name);
    }

    public Token peek() {
        return tokens.get(next);
    }

    public Token peekSecond() {
        return tokens.get(Math.min(next + 1, tokens.size() - 1));
    }

    public Token previous() {
        return tokens.get(Math.max(0, next - 1));
    }

    public Token advance() {
        Token token = tokens.get(next);
        if (token.kind() != Kind.END) {
            next++;
        }
        return token;
    }

    public boolean check(Kind kind) {
        return tokens.get(next).kind() == kind;
    }

    public boolean check(String word) {
        return tokens.get(next).is(word);
    }

    public boolean match(Kind kind) {
        boolean matches = tokens.get(next).kind() == kind;
        if (matches) {
            advance();
        }
        return matches;
    }

    public boolean match(String word) {
        boolean matches = tokens.get(next).is(word);
        if (matches) {
            next++;
        }
        return matches;
    }

    /** Takes a token of a kind, or complains that something else was expected, as in "a distance". */
    public Token consume(Kind kind, String expected) {
        Token token = tokens.get(next);
        if (token.kind() != kind) {
            throw unexpected(expected);
        }
        next += kind == Kind.END ? 0 : 1;
        return token;
    }

    /** Takes an equals sign, or complains that something else was expected. */
    public void equalsSign(String expected) {
        if (!check(Kind.OPERATOR) || !peek().text().equals("=")) {
            throw unexpected(expected);
        }
        advance();
    }

    /** A number of some quantity. */
    public Literal number(Quantity quantity) {
        Token written = tokens.get(next);
        if (written.kind() == Kind.NUMBER) {
            next++;
            return quantity.read(written);
        }
        String expected = quantity.what() + " (" + quantity.symbols() + ")";
        if (written.kind() != Kind.VARIABLE) {
            return quantity.read(consume(Kind.NUMBER, expected));
        }
        fillIn();
        if (!check(Kind.NUMBER)) {
            throw new ScriptException(
                    written, written.text() + " is " + peek().text() + ": " + expected + " is expected here");
        }
        try {
            return quantity.read(advance());
        } catch (ScriptException e) {
            throw new ScriptException(written, written.text() + " is " + e.getMessage());
        }
    }

    /** Puts the value of a variable in its place; leaves any other token as it is. */
    public void fillIn() {
        if (tokens.get(next).kind() == Kind.VARIABLE) {
            tokens.set(next, Variables.fillIn(peek(), variables));
        }
    }

    /** A whole number without unit. */
    public int count(String expected) {
        fillIn();
        Token token = consume(Kind.NUMBER, expected);
        try {
            return Integer.parseInt(token.text());
        } catch (NumberFormatException e) {
            throw new ScriptException(token, token.text() + ": " + expected + " is expected here");
        }
    }

    /** A number, a word, a quoted text, or all that stands together without a blank, as addresses and files do. */
    public Literal value(String expected, boolean inCall) {
        if (peek().isEnd() || check(Kind.OPEN_QUOTE) || endsValue(peek(), inCall)) {
            throw unexpected(expected);
        }
        int start = next;
        Token first = advance();
        StringBuilder all = new StringBuilder(first.written());
        while (previous().touches(peek()) && !endsValue(peek(), inCall) && !check(Kind.OPEN_QUOTE)) {
            all.append(advance().written());
        }
        boolean alone = next == start + 1;
        if (alone && first.kind() == Kind.VARIABLE) {
            next = start;
            fillIn();
            return value(expected, inCall);
        }
        if (alone && first.kind() == Kind.NUMBER) {
            return Quantity.readAny(first);
        }
        String text = alone ? first.text() : all.toString();
        Token at = alone
                ? first
                : new Token(
                        Kind.OTHER,
                        text,
                        first.line(),
                        first.column(),
                        previous().end());
        return new Literal(at, Value.text(text), all.toString());
    }

    private static boolean endsValue(Token token, boolean inCall) {
        return inCall && (token.kind() == Kind.COMMA || token.kind() == Kind.RIGHT);
    }

    /** Checks that nothing more stands on the line. */
    public void endOfLine() {
        if (peek().isEnd()) {
            return;
        }
        if (check(Kind.OPEN_QUOTE)) {
            throw unexpected("nothing");
        }
        refuseDecimalComma();
        throw new ScriptException(
                peek(), peek().written() + ": nothing more is expected behind \"" + lineSoFar() + "\"");
    }

    /**
     * Where something else is expected, a comma between two numbers that touch it is meant as a decimal point. A call
     * has taken it for a separator.
     */
    public void refuseDecimalComma() {
        refuseDecimalComma(next);
        if (next > 2 && tokens.get(next - 3).kind() == Kind.LEFT) {
            refuseDecimalComma(next - 1);
        }
    }

    private void refuseDecimalComma(int comma) {
        Token before = tokens.get(Math.max(0, comma - 1));
        Token sign = tokens.get(comma);
        Token behind = tokens.get(Math.min(comma + 1, tokens.size() - 1));
        boolean together = sign.kind() == Kind.COMMA && before.touches(sign) && sign.touches(behind);
        if (together && before.text().matches("-?\\d+") && behind.text().matches("\\d+\\D*")) {
            throw new ScriptException(
                    before,
                    before.text() + "," + behind.text() + ": a number has a decimal point; write " + before.text() + "."
                            + behind.text());
        }
    }

    /** What was written of this line so far. */
    private String lineSoFar() {
        int start = next;
        while (start > 0 && !tokens.get(start - 1).isEnd()) {
            start--;
        }
        StringBuilder text = new StringBuilder();
        for (int index = start; index < next; index++) {
            boolean apart = index > start && !tokens.get(index - 1).touches(tokens.get(index));
            text.append(apart ? " " : "").append(tokens.get(index).written());
        }
        return text.toString();
    }

    public void toNextLine() {
        while (!peek().isEnd()) {
            advance();
        }
    }

    public ScriptException unexpected(String expected) {
        refuseDecimalComma();
        Token found = peek();
        if (found.kind() == Kind.OPEN_QUOTE) {
            return new ScriptException(found, found.text() + ": the quote is not closed");
        }
        if (found.kind() == Kind.VARIABLE) {
            return new ScriptException(
                    found, found.text() + ": an argument stands for a value, and " + expected + " is expected here");
        }
        if (!found.isEnd()) {
            return new ScriptException(found, found.written() + ": " + expected + " is expected here", expected);
        }
        String where =
                next == 0 || previous().isEnd() ? "" : "behind \"" + previous().written() + "\" ";
        return new ScriptException(found, where + expected + " is missing", expected);
    }
}
