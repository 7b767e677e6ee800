package majic.script.syntax;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Parameter;
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
     * @throws ScriptException if it is a time in milliseconds without its unit
     */
    public Value valueFor(Parameter parameter) {
        if (parameter.unit() == Unit.MS
                && value instanceof Value.Number number
                && number.unit() == Unit.NONE
                && number.amount() != 0) {
            throw new ScriptException(
                    at, text + ": the unit of the time is missing; write " + text + "ms or " + text + "s");
        }
        return value;
    }

    /** What a number in a script counts: each quantity has the unit answers use, and further ones that may be typed. */
    enum Quantity {
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
        String what() {
            return what;
        }

        /** The units it may be typed in. */
        String symbols() {
            return symbols;
        }

        /** The number in the unit answers use; it must be of this quantity or bare. */
        Literal read(Token token) {
            Literal literal = readAny(token);
            Value.Number number = (Value.Number) literal.value();
            if (number.unit() != Unit.NONE && number.unit() != unit) {
                throw new ScriptException(token, token.text() + ": " + what + " is expected here (" + symbols + ")");
            }
            return new Literal(token, Value.of(number.amount(), unit), token.text());
        }

        /** The number in the unit answers use, whatever it counts. */
        static Literal readAny(Token token) {
            Matcher parts = PARTS.matcher(token.text());
            if (!parts.matches()) {
                throw new ScriptException(token, token.text() + ": not a number");
            }
            double amount = Double.parseDouble(parts.group(1));
            String symbol = parts.group(2).toLowerCase(Locale.ROOT);
            Value.Number number = symbol.isEmpty() ? bare(amount, token) : withUnit(amount, symbol, token);
            return new Literal(token, number, token.text());
        }

        private static Value.Number withUnit(double amount, String symbol, Token token) {
            for (Quantity quantity : values()) {
                Double factor = quantity.factors.get(symbol);
                if (factor != null) {
                    return number(amount * factor, quantity.unit, token);
                }
            }
            throw new ScriptException(
                    token,
                    token.text()
                            + ": no such unit (there are mm, cm, m, deg, rad, mm/s, m/s, deg/s, rad/s, mm/s², m/s², deg/s², s, ms, V, %,"
                            + " °C)");
        }

        private static Value.Number bare(double amount, Token token) {
            return number(amount, Unit.NONE, token);
        }

        private static Value.Number number(double amount, Unit unit, Token token) {
            if (!Double.isFinite(amount)) {
                throw new ScriptException(token, token.text() + ": too large a number");
            }
            return new Value.Number(amount, unit, false);
        }
    }
}
