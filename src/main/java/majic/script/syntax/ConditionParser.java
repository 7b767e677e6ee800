package majic.script.syntax;

import java.util.List;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Token.Kind;
import org.jspecify.annotations.Nullable;

/** The rules for conditions. */
public final class ConditionParser {
    /** Deeper than any sensible condition, and far from the end of the stack. */
    private static final int DEEPEST = 100;

    private final Cursor at;
    private int depth;

    public ConditionParser(Cursor at) {
        this.at = at;
    }

    /**
     * Parses a text that is a condition and nothing else.
     *
     * @throws ScriptException if it is not
     */
    public static Condition parse(String text) {
        Cursor at = new Cursor(Scanner.scan(text));
        Condition condition = new ConditionParser(at).condition();
        at.endOfLine();
        return condition;
    }

    /** Parses a condition: {@code condition = conjunction { "or" conjunction } ;}. */
    public Condition condition() {
        Condition left = conjunction();
        while (at.match("or")) {
            left = new Condition.Or(left, conjunction());
        }
        return left;
    }

    /** {@code conjunction = negation { "and" negation } ;} */
    private Condition conjunction() {
        Condition left = negation();
        while (at.match("and")) {
            left = new Condition.And(left, negation());
        }
        return left;
    }

    /** {@code negation = "not" negation | "(" condition ")" | comparison | known ;} */
    private Condition negation() {
        if (startsKnown()) {
            return known();
        }
        if (!at.check("not") && !at.check(Kind.LEFT)) {
            return comparison();
        }
        if (++depth > DEEPEST) {
            throw new ScriptException(at.peek(), "the condition is nested too deeply");
        }
        Condition inner = at.match("not") ? new Condition.Not(negation()) : brackets();
        depth--;
        return inner;
    }

    private Condition brackets() {
        at.advance();
        Condition inner = condition();
        at.consume(Kind.RIGHT, "\")\"");
        return inner;
    }

    /** {@code comparison = [ "any" | robots ] PARAMETER operator literal ;} */
    private Condition comparison() {
        Robots robots = robots();
        Token parameter = at.consume(Kind.WORD, "a parameter");
        Operator operator = operator();
        return new Condition.Comparison(robots, parameter, operator, literal());
    }

    private boolean startsKnown() {
        boolean compared = at.peekSecond().kind() == Kind.OPERATOR;
        return switch (at.peek().kind()) {
            case VARIABLE -> true;
            case NUMBER, QUOTED -> compared;
            case LEFT -> Expression.isInBrackets(at);
            default -> false;
        };
    }

    /** {@code known = ( NUMBER | QUOTED | VARIABLE | "(" expression ")" ) operator literal ;} */
    private Condition known() {
        Literal left = literal();
        Operator operator = operator();
        Literal right = literal();
        return compared(left, operator, right);
    }

    /** Puts two values together that can be compared. */
    private static Condition.Known compared(Literal left, Operator operator, Literal right) {
        boolean maybeAny = isMaybeAny(left) || isMaybeAny(right);
        boolean numbers = isOrdered(left) && isOrdered(right);
        if (!maybeAny && !numbers && !operator.isEquality()) {
            Literal word = isOrdered(left) ? right : left;
            throw new ScriptException(
                    word.at(), word.text() + ": not a number; it can be compared with == and != only");
        }
        if (!maybeAny && isOrdered(left) != isOrdered(right)) {
            throw new ScriptException(
                    right.at(), right.text() + ": cannot be compared with " + left.text() + ", it is of another kind");
        }
        Unit first = unit(left);
        Unit second = unit(right);
        if (numbers && first != second && first != Unit.NONE && second != Unit.NONE) {
            throw new ScriptException(
                    right.at(),
                    right.text() + ": " + first.symbol() + " and " + second.symbol() + " cannot be compared");
        }
        return new Condition.Known(left, operator, right);
    }

    /** A bare number that is not known yet may turn out to be anything. */
    private static boolean isMaybeAny(Literal literal) {
        return literal.at().open() && unit(literal) == Unit.NONE;
    }

    private static boolean isOrdered(Literal literal) {
        return literal.value() instanceof Value.Number || literal.text().equalsIgnoreCase("clear");
    }

    private static Unit unit(Literal literal) {
        return literal.value() instanceof Value.Number number ? number.unit() : Unit.NONE;
    }

    private @Nullable Robots robots() {
        if (at.check("any")) {
            Token any = at.advance();
            return new Robots(any, List.of(new Robots.Any(any)));
        }
        boolean parameterFirst = at.check(Kind.WORD)
                && at.peekSecond().kind() != Kind.WORD
                && at.peekSecond().kind() != Kind.COMMA;
        return parameterFirst || at.peek().isEnd() ? null : Robots.parse(at);
    }

    /** {@code operator = "<" | "<=" | ">" | ">=" | "==" | "!=" ;} */
    private Operator operator() {
        Token token = at.consume(Kind.OPERATOR, "one of < <= > >= == !=");
        return Operator.of(token.text()).orElseThrow(() -> new ScriptException(token, "=: write == to compare"));
    }

    /** {@code literal = NUMBER | WORD | QUOTED | VARIABLE | "(" expression ")" ;} */
    private Literal literal() {
        at.fillIn();
        if (!at.check(Kind.NUMBER) && !at.check(Kind.WORD) && !at.check(Kind.QUOTED)) {
            throw at.unexpected("a value");
        }
        Token token = at.advance();
        return token.kind() == Kind.NUMBER
                ? Quantity.readAny(token)
                : new Literal(token, Value.text(token.text()), token.written());
    }
}
