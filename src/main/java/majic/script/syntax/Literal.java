package majic.script.syntax;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * A value as written in a script.
 *
 * @param at where
 * @param value a number in the unit that answers use, without unit if none was written; or a text
 * @param text as it was written
 */
public record Literal(Token at, Value value, String text) {
    /** The number that is the value. */
    public double number() {
        return value.number();
    }

    /** The value as an expression has it: the word {@code clear} is greater than any number. */
    public Value computable() {
        return at.kind() == Token.Kind.WORD && text.equalsIgnoreCase(Value.CLEAR.toString()) ? Value.CLEAR : value;
    }

    /** The written characters without quotes, even if they look like a number. */
    public String unquoted() {
        return at.kind() == Token.Kind.QUOTED && text.equals(at.written()) ? at.text() : text;
    }

    /**
     * The file that is named.
     *
     * @throws ScriptException if no file can have that name
     */
    public Path path() {
        try {
            return Path.of(unquoted());
        } catch (InvalidPathException e) {
            throw new ScriptException(at, text + ": no file can have that name");
        }
    }

    /**
     * The value for a parameter. Wherever else a script has a time without a unit, it is in seconds, so one that would
     * be in milliseconds needs its unit.
     *
     * <p>Before a run, a value that is known only when the line runs is replaced by one that the parameter takes.
     *
     * @throws ScriptException if it is a time in milliseconds without its unit
     */
    public Value valueFor(Parameter parameter) {
        if (at.open()) {
            return sampleFor(parameter);
        }
        if (parameter.unit() == Unit.MS
                && value instanceof Value.Number number
                && number.unit() == Unit.NONE
                && number.amount() != 0) {
            throw new ScriptException(
                    at, text + ": the unit of the time is missing; write " + text + "ms or " + text + "s");
        }
        return value;
    }

    /** A number keeps its unit, so that a wrong one is found. */
    private Value sampleFor(Parameter parameter) {
        Range range = parameter.range();
        double inRange = Math.max(range.min(), Math.min(range.max(), 0));
        boolean bare = value instanceof Value.Number number && number.unit() == Unit.NONE;
        return switch (parameter.kind()) {
            case NUMBER ->
                value instanceof Value.Number number
                        ? Value.of(inRange, bare ? parameter.unit() : number.unit())
                        : value;
            case YES_NO -> bare || !(value instanceof Value.Number) ? Value.yesNo(true) : value;
            case ON_OFF -> bare || !(value instanceof Value.Number) ? Value.onOff(true) : value;
            case CHOICE ->
                bare || !(value instanceof Value.Number)
                        ? Value.text(parameter.choices().get(0))
                        : value;
            case TEXT, LIST -> value;
        };
    }

    /** What a number in a script counts: each quantity has the unit answers use, and further ones that may be typed. */
    public enum Quantity {
        DISTANCE("a distance", Unit.MM, Map.of("mm", 1.0, "cm", 10.0, "m", 1000.0), "mm, cm, m"),
        ANGLE("an angle", Unit.DEG, Map.of("deg", 1.0, "rad", 180 / Math.PI), "deg, rad"),
        SPEED("a speed", Unit.MM_PER_S, Map.of("mm/s", 1.0, "m/s", 1000.0), "mm/s, m/s"),
        TURN_RATE("a turn rate", Unit.DEG_PER_S, Map.of("deg/s", 1.0, "rad/s", 180 / Math.PI), "deg/s, rad/s"),
        ACCELERATION(
                "an acceleration",
                Unit.MM_PER_S2,
                Map.of("mm/s²", 1.0, "mm/s2", 1.0, "m/s²", 1000.0, "m/s2", 1000.0),
                "mm/s², m/s²"),
        TURN_ACCELERATION("a turn's acceleration", Unit.DEG_PER_S2, Map.of("deg/s²", 1.0, "deg/s2", 1.0), "deg/s²"),
        TIME("a time", Unit.S, Map.of("s", 1.0, "ms", 0.001), "s, ms"),
        VOLTAGE("a voltage", Unit.V, Map.of("v", 1.0), "V"),
        SHARE("a percentage", Unit.PERCENT, Map.of("%", 1.0), "%"),
        TEMPERATURE("a temperature", Unit.CELSIUS, Map.of("°c", 1.0), "°C");

        private static final Pattern PARTS = Pattern.compile("(-?[\\d.]+)(.*)");

        private final String what;
        private final Unit unit;
        private final Map<String, Double> factors;
        private final String symbols;

        Quantity(String what, Unit unit, Map<String, Double> factors, String symbols) {
            this.what = what;
            this.unit = unit;
            this.factors = factors;
            this.symbols = symbols;
        }

        /** A distance, an angle and so on, as messages call it. */
        public String what() {
            return what;
        }

        /** The units it may be typed in. */
        public String symbols() {
            return symbols;
        }

        /** The number in the unit answers use; it must be of this quantity or bare. */
        public Literal read(Token token) {
            Matcher parts = parts(token);
            String symbol = symbol(parts);
            if (!symbol.isEmpty() && !factors.containsKey(symbol)) {
                of(symbol, token);
                throw new ScriptException(token, token.text() + ": " + what + " is expected here (" + symbols + ")");
            }
            return literal(parts, symbol.isEmpty() ? 1 : factors.get(symbol), unit, token);
        }

        /** The number in the unit answers use, whatever it counts. */
        public static Literal readAny(Token token) {
            Matcher parts = parts(token);
            String symbol = symbol(parts);
            if (symbol.isEmpty()) {
                return literal(parts, 1, Unit.NONE, token);
            }
            Quantity quantity = of(symbol, token);
            return literal(parts, quantity.factors.get(symbol), quantity.unit, token);
        }

        private static Matcher parts(Token token) {
            Matcher parts = PARTS.matcher(token.text());
            if (!parts.matches()) {
                throw new ScriptException(token, token.text() + ": not a number");
            }
            return parts;
        }

        private static String symbol(Matcher parts) {
            return parts.group(2).toLowerCase(Locale.ROOT);
        }

        private static Quantity of(String symbol, Token token) {
            for (Quantity quantity : values()) {
                if (quantity.factors.containsKey(symbol)) {
                    return quantity;
                }
            }
            throw new ScriptException(
                    token,
                    token.text()
                            + ": no such unit (there are mm, cm, m, deg, rad, mm/s, m/s, deg/s, rad/s, mm/s², m/s², deg/s², s, ms, V, %,"
                            + " °C)");
        }

        private static Literal literal(Matcher parts, double factor, Unit unit, Token token) {
            double amount = Double.parseDouble(parts.group(1)) * factor;
            if (!Double.isFinite(amount)) {
                throw new ScriptException(token, token.text() + ": too large a number");
            }
            return new Literal(token, new Value.Number(amount, unit, false), parts.group());
        }
    }
}
