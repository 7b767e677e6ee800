package majic.script.syntax;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import majic.bot.Value;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Token.Kind;

/** The rules for expressions. A rule returns the value at once. */
final class Expression {
    /** The words that begin a function. */
    static final Set<String> FUNCTIONS = Set.of("abs", "bearing", "distance", "max", "min", "random");

    /** Words that are values also where a parameter may stand alone. */
    private static final Set<String> NO_PARAMETERS = Set.of("no", "off", "on", "yes");

    /** Deeper than any sensible expression, and far from the end of the stack. */
    private static final int DEEPEST = 100;

    private final Cursor at;
    private int depth;

    private Expression(Cursor at) {
        this.at = at;
    }

    /** {@code "(" expression ")"}, where the cursor is at the bracket. */
    static Operand inBrackets(Cursor at) {
        return new Expression(at).brackets();
    }

    /** An expression without brackets around it. */
    static Operand parse(Cursor at) {
        return new Expression(at).expression();
    }

    /** {@code expression = term { ( "+" | "-" ) term } ;} A sign that touches a number is written as part of it. */
    private Operand expression() {
        Operand left = term();
        while (true) {
            Token sign = at.peek();
            if (isSign(sign, "+")) {
                at.advance();
                left = Arithmetic.add(left, term(), sign);
            } else if (isSign(sign, "-")) {
                at.advance();
                left = Arithmetic.subtract(left, term(), sign);
            } else if (isSigned(sign)) {
                left = Arithmetic.add(left, term(), sign);
            } else {
                return left;
            }
        }
    }

    /** {@code term = factor { ( "*" | "/" ) factor } ;} */
    private Operand term() {
        Operand left = factor();
        while (true) {
            Token sign = at.peek();
            if (isSign(sign, "*")) {
                at.advance();
                left = Arithmetic.multiply(left, factor(), sign);
            } else if (isSign(sign, "/")) {
                at.advance();
                left = Arithmetic.divide(left, factor(), sign);
            } else {
                return left;
            }
        }
    }

    private static boolean isSign(Token token, String sign) {
        return token.kind() == Kind.OTHER && token.text().equals(sign);
    }

    private static boolean isSigned(Token token) {
        return (token.kind() == Kind.NUMBER || token.kind() == Kind.VARIABLE)
                && token.text().startsWith("-");
    }

    /** {@code factor = "-" factor | "(" expression ")" | VARIABLE | function | reading | NUMBER | WORD | QUOTED ;} */
    private Operand factor() {
        Token first = at.peek();
        if (isSign(first, "-")) {
            at.advance();
            deeper(first);
            Operand inner = Arithmetic.negate(factor(), first);
            depth--;
            return inner;
        }
        return switch (first.kind()) {
            case LEFT -> brackets();
            case VARIABLE -> at.variable();
            case QUOTED -> Operand.of(Value.text(at.advance().text()));
            case WORD -> first.isOneOf(FUNCTIONS) ? function(at.advance()) : word(first);
            case NUMBER ->
                at.peekSecond().kind() == Kind.WORD && !at.peekSecond().is("to")
                        ? reading()
                        : Operand.of(Quantity.readAny(at.advance()).value());
            case SPAN ->
                throw new ScriptException(
                        first,
                        first.text() + ": write blanks around a minus, as in "
                                + first.text().replace("-", " - "));
            default -> throw at.unexpected("a value (a number, $name, a robot and its parameter, a bracket)");
        };
    }

    private Operand brackets() {
        deeper(at.peek());
        at.advance();
        Operand inner = expression();
        at.consume(Kind.RIGHT, "\")\"");
        depth--;
        return inner;
    }

    private void deeper(Token place) {
        if (++depth > DEEPEST) {
            throw new ScriptException(place, "the expression is nested too deeply");
        }
    }

    /** A word before another one is a robot; a word alone is a parameter of the robot of the line, or itself. */
    private Operand word(Token word) {
        Kind next = at.peekSecond().kind();
        if (next == Kind.WORD || next == Kind.COMMA) {
            return reading();
        }
        if (word.is("clear")) {
            at.advance();
            return Operand.of(Value.CLEAR);
        }
        Robots own = at.ownRobots();
        if (own == null || word.isOneOf(NO_PARAMETERS)) {
            return Operand.of(Value.text(at.advance().text()));
        }
        return at.reading(own, at.advance());
    }

    /** {@code reading = robots PARAMETER ;} */
    private Operand reading() {
        Robots robots = Robots.parse(at);
        return at.reading(robots, at.consume(Kind.WORD, "a parameter"));
    }

    /**
     * {@code function = ( "min" | "max" ) factor factor | "abs" factor | "random" factor factor | ( "distance" |
     * "bearing" ) end end ;}
     */
    private Operand function(Token name) {
        deeper(name);
        Operand result = switch (name.text().toLowerCase(Locale.ROOT)) {
            case "abs" -> Arithmetic.absolute(factor(), name);
            case "min" -> Arithmetic.least(factor(), factor(), name);
            case "max" -> Arithmetic.greatest(factor(), factor(), name);
            case "random" -> random(name);
            default -> at.between(name, List.of(end(), end()));
        };
        depth--;
        return result;
    }

    private Operand random(Token name) {
        Operand from = factor();
        at.match("to");
        Operand to = factor();
        return at.random(from, to, name);
    }

    /** {@code end = NUMBER | NAME | VARIABLE | "(" expression ")" ;} */
    private Token end() {
        at.fillIn();
        if (at.check(Kind.WORD) || at.check(Kind.NUMBER) || at.check(Kind.QUOTED)) {
            return at.advance();
        }
        throw at.unexpected("the number or the name of a robot, or the name of a place");
    }

    /** Whether the bracket where a cursor is holds an expression, and not a condition: no comparison stands in it. */
    static boolean isInBrackets(Cursor at) {
        int open = 0;
        for (int ahead = 0; !at.peek(ahead).isEnd(); ahead++) {
            Token token = at.peek(ahead);
            if (token.kind() == Kind.LEFT) {
                open++;
            } else if (token.kind() == Kind.RIGHT && --open == 0) {
                return true;
            } else if (token.kind() == Kind.OPERATOR || token.is("not") || token.is("and") || token.is("or")) {
                return false;
            }
        }
        return false;
    }
}
