package majic.script.commands;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Cursor;
import majic.script.syntax.Literal;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Operand;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;

/** The rule for the lines that a script begins with, one for each of its arguments. */
final class ArgumentParser {
    private final Cursor at;
    private final Types types;
    private final Map<String, Value> given;

    /**
     * Creates a parser.
     *
     * @param given the values of arguments by name in lower case; an argument without one has its default
     */
    ArgumentParser(Cursor at, Types types, Map<String, Value> given) {
        this.at = at;
        this.types = types;
        this.given = given;
    }

    /**
     * {@code argument = "argument" WORD "=" ( NUMBER bounds | QUOTED | WORD { "or" WORD } ) [ QUOTED ] NEWLINE ;} From
     * then on the name stands for the argument's value, even if the rest of the line is wrong.
     */
    Statement.Argument argument() {
        Token first = at.advance();
        Token name = name(at, "an argument's name");
        if (types.knows(name.text())) {
            throw new ScriptException(name, name.text() + ": there is an argument of that name already");
        }
        at.equalsSign("= and the default");
        Described described = described(at, name, initial -> types.argument(name, Operand.of(initial)));
        at.endOfLine();
        Value value = given.getOrDefault(name.text().toLowerCase(Locale.ROOT), described.initial());
        types.argument(name, Operand.of(value));
        return new Statement.Argument(first, name, described.parameter(), described.initial(), value);
    }

    /** The name of a value has no slash in it, unlike other words. */
    static Token name(Cursor at, String expected) {
        Token name = at.consume(Kind.WORD, expected);
        if (name.text().contains("/")) {
            throw new ScriptException(name, name.text() + ": a name is a letter, then letters, digits and _");
        }
        return name;
    }

    /**
     * A value that a person gives.
     *
     * @param parameter what it may be, with the text in quotes as its help
     * @param initial the default, in the form that the parameter takes
     */
    record Described(Parameter parameter, Value initial) {}

    /**
     * {@code described = NUMBER bounds [ QUOTED ] | QUOTED [ QUOTED ] | WORD { "or" WORD } [ QUOTED ] ;}
     *
     * @param begun receives the default before the rest is parsed
     */
    static Described described(Cursor at, Token name, Consumer<Value> begun) {
        Literal initial = initial(at);
        begun.accept(initial.value());
        return switch (initial.at().kind()) {
            case NUMBER -> number(at, name, initial);
            case QUOTED -> new Described(Parameter.text(name.text(), help(at)), initial.value());
            default -> words(at, name, initial);
        };
    }

    private static Literal initial(Cursor at) {
        if (at.check(Kind.NUMBER)) {
            return Quantity.readAny(at.advance());
        }
        if (!at.check(Kind.WORD) && !at.check(Kind.QUOTED)) {
            throw at.unexpected("the default, a number, a word or a text in quotes,");
        }
        Token token = at.advance();
        return new Literal(token, Value.text(token.text()), token.written());
    }

    private static Described number(Cursor at, Token name, Literal initial) {
        Value.Number number = (Value.Number) initial.value();
        double min = at.match("from") ? bound(at, number.unit()) : Range.ANY.min();
        double max = at.match("to") ? bound(at, number.unit()) : Range.ANY.max();
        if (min > max) {
            throw new ScriptException(
                    at.previous(), at.previous().text() + ": the highest value is less than the lowest");
        }
        Parameter parameter =
                Parameter.number(name.text(), number.unit(), help(at)).within(min, max);
        return new Described(parameter, initial.at().resolve(() -> parameter.fit(number)));
    }

    private static double bound(Cursor at, Unit unit) {
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

    private static Described words(Cursor at, Token name, Literal initial) {
        List<String> words = new ArrayList<>(List.of(initial.text()));
        while (at.match("or")) {
            words.add(at.consume(Kind.WORD, "a word").text());
        }
        String help = help(at);
        try {
            Parameter parameter = Parameter.words(name.text(), words, help);
            return new Described(parameter, parameter.fit(initial.value()));
        } catch (IllegalArgumentException e) {
            throw new ScriptException(
                    initial.at(),
                    initial.text() + ": the default is a number, yes, no, on, off, a text in quotes, or one of several"
                            + " words, as in left or right");
        }
    }

    private static String help(Cursor at) {
        return at.check(Kind.QUOTED) ? at.advance().text() : "";
    }
}
