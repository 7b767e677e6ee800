package majic.script.commands;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.run.Statement;
import majic.script.syntax.Cursor;
import majic.script.syntax.Literal;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;

/** The rule for the lines that a script begins with, one for each of its arguments. */
final class ArgumentParser {
    private final Cursor at;
    private final Map<String, Value> given;

    /**
     * Creates a parser.
     *
     * @param given the values of arguments by name in lower case; an argument without one has its default
     */
    ArgumentParser(Cursor at, Map<String, Value> given) {
        this.at = at;
        this.given = given;
    }

    /**
     * {@code argument = "argument" WORD "=" ( NUMBER bounds | QUOTED | WORD { "or" WORD } ) [ QUOTED ] NEWLINE ;} From
     * then on the name stands for the argument's value, even if the rest of the line is wrong.
     */
    Statement.Argument argument() {
        Token first = at.advance();
        Token name = name();
        at.equalsSign("= and the default");
        String key = name.text().toLowerCase(Locale.ROOT);
        if (at.isDefined(key)) {
            throw new ScriptException(name, name.text() + ": there is an argument of that name already");
        }
        Literal initial = initial();
        at.define(key, initial.value());
        Statement.Argument argument = switch (initial.at().kind()) {
            case NUMBER -> number(first, name, initial);
            case QUOTED -> new Statement.Argument(first, Parameter.text(name.text(), help()), initial.value());
            default -> words(first, name, initial);
        };
        at.endOfLine();
        at.define(key, given.getOrDefault(key, argument.initial()));
        return argument;
    }

    /** A variable has no slash in it, unlike other words. */
    private Token name() {
        Token name = at.consume(Kind.WORD, "an argument's name");
        if (name.text().contains("/")) {
            throw new ScriptException(
                    name, name.text() + ": the name of an argument is a letter, then letters, digits and _");
        }
        return name;
    }

    private Literal initial() {
        if (at.check(Kind.NUMBER)) {
            return Quantity.readAny(at.advance());
        }
        if (!at.check(Kind.WORD) && !at.check(Kind.QUOTED)) {
            throw at.unexpected("the default, a number, a word or a text in quotes,");
        }
        Token token = at.advance();
        return new Literal(token, Value.text(token.text()), token.written());
    }

    private Statement.Argument number(Token first, Token name, Literal initial) {
        Value.Number number = (Value.Number) initial.value();
        double min = at.match("from") ? bound(number.unit()) : Range.ANY.min();
        double max = at.match("to") ? bound(number.unit()) : Range.ANY.max();
        if (min > max) {
            throw new ScriptException(
                    at.previous(), at.previous().text() + ": the highest value is less than the lowest");
        }
        Parameter parameter =
                Parameter.number(name.text(), number.unit(), help()).within(min, max);
        return new Statement.Argument(first, parameter, initial.at().resolve(() -> parameter.fit(number)));
    }

    private double bound(Unit unit) {
        Token token = at.consume(Kind.NUMBER, "a number");
        Value.Number number = (Value.Number) Quantity.readAny(token).value();
        if (number.unit() != Unit.NONE && number.unit() != unit) {
            throw new ScriptException(
                    token,
                    token.text() + ": not in the unit of the default"
                            + (unit == Unit.NONE ? ", which has none" : ", " + unit.symbol()));
        }
        return number.amount();
    }

    private Statement.Argument words(Token first, Token name, Literal initial) {
        List<String> words = new ArrayList<>(List.of(initial.text()));
        while (at.match("or")) {
            words.add(at.consume(Kind.WORD, "a word").text());
        }
        String help = help();
        try {
            Parameter parameter = Parameter.words(name.text(), words, help);
            return new Statement.Argument(first, parameter, parameter.fit(initial.value()));
        } catch (IllegalArgumentException e) {
            throw new ScriptException(
                    initial.at(),
                    initial.text() + ": the default is a number, yes, no, on, off, a text in quotes, or one of several"
                            + " words, as in left or right");
        }
    }

    private String help() {
        return at.check(Kind.QUOTED) ? at.advance().text() : "";
    }
}
