package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Value;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Token.Kind;
import org.jspecify.annotations.Nullable;

/**
 * A place in a list of tokens that moves forward: the helpers that every grammar rule is written with. Where a value
 * stands that has to be computed, the cursor shows a token with the value in place of its tokens.
 */
public final class Cursor {
    private final List<Token> tokens;
    private final Values values;
    private final int start;
    private int next;
    private Token current;
    private Token previous;

    /** Where to go on behind a computed value that is shown in place of its tokens; else -1. */
    private int behindComputed = -1;

    private @Nullable Robots ownRobots;
    private int lastOpen = -1;
    private final List<PlacedReading> readings = new ArrayList<>();

    /**
     * A reading in an expression: the parameter of a robot.
     *
     * @param orPlace whether the word may be a place of the map as well, which is not read
     */
    public record Reading(Robots robots, Token parameter, boolean orPlace) {}

    private record PlacedReading(int place, Reading reading) {}

    /** For a text without names and readings; the last token is an END. */
    public Cursor(List<Token> tokens) {
        this(tokens, 0, Values.NONE);
    }

    /**
     * For a text from one of its tokens on.
     *
     * @param tokens the last one is an END
     * @param start index of the first token
     * @param values what names and readings stand for
     */
    public Cursor(List<Token> tokens, int start, Values values) {
        this.tokens = tokens;
        this.values = values;
        this.start = start;
        this.next = start;
        this.current = tokens.get(start);
        this.previous = tokens.get(Math.max(0, start - 1));
    }

    /** What the names and readings of the text stand for. */
    public Values values() {
        return values;
    }

    List<Token> tokens() {
        return tokens;
    }

    /** Other cursors in the same text, one behind each word that begins a line. */
    public List<Cursor> behindFirst(String word) {
        List<Cursor> found = new ArrayList<>();
        for (int index = 0; index < tokens.size(); index++) {
            if (tokens.get(index).is(word)
                    && (index == 0 || tokens.get(index - 1).isEnd())) {
                found.add(new Cursor(tokens, index + 1, values));
            }
        }
        return found;
    }

    /** The index of the next token. */
    public int place() {
        return next;
    }

    /** Whether a value that was not known has stood at a place or behind it. */
    public boolean isOpenSince(int place) {
        return lastOpen >= place;
    }

    /** The readings in expressions at a place and behind it. */
    List<Reading> readingsSince(int place) {
        return readings.stream()
                .filter(placed -> placed.place >= place)
                .map(PlacedReading::reading)
                .toList();
    }

    /** Takes notice that what stands here has to be parsed again when it runs, whatever its values are. */
    public void markOpen() {
        lastOpen = next;
    }

    /** Sets the robots of the line, whose parameters an expression may name alone; null behind the line. */
    public void setOwnRobots(@Nullable Robots robots) {
        ownRobots = robots;
    }

    @Nullable
    Robots ownRobots() {
        return ownRobots;
    }

    public Token peek() {
        return current;
    }

    public Token peekSecond() {
        return peek(1);
    }

    /** A token some places ahead. */
    Token peek(int ahead) {
        if (ahead == 0) {
            return current;
        }
        int from = behindComputed < 0 ? next : behindComputed - 1;
        return tokens.get(Math.min(from + ahead, tokens.size() - 1));
    }

    public Token previous() {
        return previous;
    }

    public Token advance() {
        Token token = current;
        if (behindComputed >= 0 || next < tokens.size() - 1) {
            next = behindComputed >= 0 ? behindComputed : next + 1;
            behindComputed = -1;
            current = tokens.get(next);
            previous = token;
        }
        return token;
    }

    public boolean check(Kind kind) {
        return current.kind() == kind;
    }

    public boolean check(String word) {
        return current.is(word);
    }

    public boolean match(Kind kind) {
        boolean matches = current.kind() == kind;
        if (matches) {
            advance();
        }
        return matches;
    }

    public boolean match(String word) {
        boolean matches = current.is(word);
        if (matches) {
            advance();
        }
        return matches;
    }

    /** Takes a token of a kind, or complains that something else was expected, as in "a distance". */
    public Token consume(Kind kind, String expected) {
        if (current.kind() != kind) {
            throw unexpected(expected);
        }
        return advance();
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
        fillIn();
        if (check(Kind.NUMBER) && behindComputed < 0) {
            return quantity.read(advance());
        }
        String expected = quantity.what() + " (" + quantity.symbols() + ")";
        if (behindComputed < 0) {
            throw unexpected(expected);
        }
        String written = text(next, behindComputed);
        Token token = peek();
        if (token.kind() != Kind.NUMBER) {
            throw new ScriptException(
                    token,
                    written + (token.open() ? " is a word: " : " is " + token.text() + ": ") + expected
                            + " is expected here");
        }
        try {
            return quantity.read(advance());
        } catch (ScriptException e) {
            throw new ScriptException(
                    token,
                    token.open() ? written + ": " + expected + " is expected here" : written + " is " + e.getMessage());
        }
    }

    /** Whether a value that has to be computed begins here: a name, or a bracket. */
    public boolean startsComputed() {
        return behindComputed < 0 && (current.kind() == Kind.VARIABLE || current.kind() == Kind.LEFT);
    }

    /** What stands here, as messages repeat it: instead of a value that is not known yet what was written. */
    private String found() {
        return behindComputed >= 0 && current.open() ? text(next, behindComputed) : current.written();
    }

    /** Puts the value of a name or of an expression in brackets in its place; leaves any other token as it is. */
    public void fillIn() {
        if (!startsComputed()) {
            return;
        }
        int first = next;
        Token place = peek();
        Operand value = simple();
        Token shown = value.token(place, previous.end());
        int behind = next;
        next = first;
        previous = tokens.get(Math.max(0, first - 1));
        current = shown;
        behindComputed = behind;
    }

    /** A name or an expression in brackets. */
    public Operand simple() {
        return check(Kind.VARIABLE) ? variable() : Expression.inBrackets(this);
    }

    /** An expression up to the end of the line or the bracket. */
    public Operand expression() {
        return Expression.parse(this);
    }

    /** Takes a name and returns its value, the opposite of it for {@code -$name}. */
    Operand variable() {
        int place = next;
        Token written = advance();
        boolean negative = written.text().startsWith("-");
        Token name = new Token(
                Kind.VARIABLE,
                written.text().substring(negative ? 1 : 0),
                written.line(),
                written.column(),
                written.end());
        Operand value = noted(values.named(name), place);
        return negative ? Arithmetic.negate(value, written) : value;
    }

    /** The value of a parameter of one robot. */
    Operand reading(Robots robots, Token parameter) {
        readings.add(new PlacedReading(next, new Reading(robots, parameter, false)));
        lastOpen = next;
        return values.reading(robots, parameter);
    }

    /** The distance or the bearing between two robots or places. */
    Operand between(Token function, List<Token> ends) {
        for (Token end : ends) {
            Token x = new Token(Kind.WORD, "x", end.line(), end.column(), end.end());
            boolean orPlace = end.kind() != Kind.NUMBER || end.open();
            readings.add(new PlacedReading(next, new Reading(Robots.of(end), x, orPlace)));
        }
        lastOpen = next;
        return values.between(function, ends);
    }

    Operand random(Operand from, Operand to, Token name) {
        lastOpen = next;
        return Arithmetic.random(from, to, name, values.random());
    }

    private Operand noted(Operand value, int place) {
        if (value.open()) {
            lastOpen = place;
        }
        return value;
    }

    /** A whole number without unit. */
    public int count(String expected) {
        fillIn();
        String written = found();
        Token token = consume(Kind.NUMBER, expected);
        if (token.open() && token.text().equals("0")) {
            return 0;
        }
        try {
            return Integer.parseInt(token.text());
        } catch (NumberFormatException e) {
            throw new ScriptException(token, written + ": " + expected + " is expected here");
        }
    }

    /** A number, a word, a quoted text, or all that stands together without a blank, as addresses and files do. */
    public Literal value(String expected, boolean inCall) {
        if (peek().isEnd() || check(Kind.OPEN_QUOTE) || endsValue(peek(), inCall)) {
            throw unexpected(expected);
        }
        if (check(Kind.LEFT)) {
            fillIn();
        } else if (check(Kind.VARIABLE) && !stands(1, inCall)) {
            fillIn();
        }
        if (behindComputed >= 0) {
            Token token = advance();
            return token.kind() == Kind.NUMBER
                    ? Quantity.readAny(token)
                    : new Literal(token, Value.text(token.text()), token.written());
        }
        Token first = advance();
        StringBuilder all = new StringBuilder(first.written());
        boolean alone = true;
        while (previous.touches(peek()) && !endsValue(peek(), inCall) && !check(Kind.OPEN_QUOTE)) {
            all.append(advance().written());
            alone = false;
        }
        if (alone && first.kind() == Kind.NUMBER) {
            return Quantity.readAny(first);
        }
        String text = alone ? first.text() : all.toString();
        Token at = alone ? first : new Token(Kind.OTHER, text, first.line(), first.column(), previous.end());
        return new Literal(at, Value.text(text), all.toString());
    }

    /** Whether a token some places ahead touches the one before it, as part of the same value. */
    private boolean stands(int ahead, boolean inCall) {
        Token token = peek(ahead);
        return peek(ahead - 1).touches(token) && !endsValue(token, inCall) && token.kind() != Kind.OPEN_QUOTE;
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
        throw new ScriptException(peek(), found() + ": nothing more is expected behind \"" + lineSoFar() + "\"");
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
        return text(start, next);
    }

    /** What was written from one token to the one before another. */
    private String text(int from, int to) {
        StringBuilder text = new StringBuilder();
        for (int index = from; index < to; index++) {
            boolean apart = index > from && !tokens.get(index - 1).touches(tokens.get(index));
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
                    found, found.text() + ": a name with $ stands for a value, and " + expected + " is expected here");
        }
        if (!found.isEnd()) {
            return new ScriptException(found, found() + ": " + expected + " is expected here", expected);
        }
        String where = next == start || previous.isEnd()
                ? ""
                : "behind \"" + previous().written() + "\" ";
        return new ScriptException(found, where + expected + " is missing", expected);
    }
}
