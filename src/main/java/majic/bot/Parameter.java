package majic.bot;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * A value of a robot that can be read or set, or one argument of a robot's own command. Immutable.
 *
 * @param name letters and digits; compared without regard to case
 * @param kind what values it takes
 * @param unit what its numbers count; a number typed without unit is in it
 * @param range the numbers it may have; what lies outside is refused
 * @param whole whether it may have whole numbers only
 * @param choices the words it may have, for {@link Kind#CHOICE}
 * @param readable whether {@code get} is allowed
 * @param writable whether {@code set} is allowed
 * @param moves whether setting it moves the robot, and so needs the robot to be free
 * @param extras further values that {@code set} or a command takes behind it, each of them optional: the time in
 *     {@code set headPan 30 500ms}
 * @param help one line for users
 */
public record Parameter(
        String name,
        Kind kind,
        Unit unit,
        Range range,
        boolean whole,
        List<String> choices,
        boolean readable,
        boolean writable,
        boolean moves,
        List<Parameter> extras,
        String help) {

    /** The largest fraction that converting seconds to milliseconds may produce by rounding. */
    private static final double CONVERSION_ERROR = 1e-6;

    private static final Pattern DECIMAL_COMMA = Pattern.compile("(-?\\d+),(\\d+\\D*)");

    /** The values that a parameter takes. */
    public enum Kind {
        /** A number in its unit. */
        NUMBER,
        /** Yes or no. */
        YES_NO,
        /** On or off. */
        ON_OFF,
        /** One of a few words. */
        CHOICE,
        /** Any text. */
        TEXT,
        /**
         * Several values that are read together; where they can be set, this is the first and the others are extras.
         */
        LIST
    }

    /** Keeps copies of the lists. */
    public Parameter {
        choices = List.copyOf(choices);
        extras = List.copyOf(extras);
    }

    /**
     * A readable number of any size.
     *
     * @param name its name
     * @param unit its unit
     * @param help one line
     * @return the description
     */
    public static Parameter number(String name, Unit unit, String help) {
        return of(name, Kind.NUMBER, unit, List.of(), help);
    }

    /**
     * A readable yes or no.
     *
     * @param name its name
     * @param help one line
     * @return the description
     */
    public static Parameter yesNo(String name, String help) {
        return of(name, Kind.YES_NO, Unit.NONE, List.of(), help);
    }

    /**
     * A readable on or off.
     *
     * @param name its name
     * @param help one line
     * @return the description
     */
    public static Parameter onOff(String name, String help) {
        return of(name, Kind.ON_OFF, Unit.NONE, List.of(), help);
    }

    /**
     * A readable word out of a few.
     *
     * @param name its name
     * @param choices the words
     * @param help one line
     * @return the description
     */
    public static Parameter choice(String name, List<String> choices, String help) {
        return of(name, Kind.CHOICE, Unit.NONE, choices, help);
    }

    /**
     * A readable word out of some.
     *
     * @param name its name
     * @param words two or more to choose from; or one of {@code on}, {@code off}, {@code yes} and {@code no} alone,
     *     which stands for both words of its pair
     * @param help one line
     * @return the description
     * @throws IllegalArgumentException if it is any other word alone
     */
    public static Parameter words(String name, List<String> words, String help) {
        if (words.size() > 1) {
            return choice(name, words, help);
        }
        return switch (words.get(0).toLowerCase(Locale.ROOT)) {
            case "on", "off" -> onOff(name, help);
            case "yes", "no" -> yesNo(name, help);
            default ->
                throw new IllegalArgumentException(
                        name + ": " + words.get(0) + " alone is no choice; give a second word");
        };
    }

    /**
     * A readable text.
     *
     * @param name its name
     * @param help one line
     * @return the description
     */
    public static Parameter text(String name, String help) {
        return of(name, Kind.TEXT, Unit.NONE, List.of(), help);
    }

    /**
     * Several readable values at once.
     *
     * @param name its name
     * @param unit the unit of each
     * @param help one line
     * @return the description
     */
    public static Parameter list(String name, Unit unit, String help) {
        return of(name, Kind.LIST, unit, List.of(), help);
    }

    private static Parameter of(String name, Kind kind, Unit unit, List<String> choices, String help) {
        return new Parameter(name, kind, unit, Range.ANY, false, choices, true, false, false, List.of(), help);
    }

    /**
     * Returns the same parameter with bounds.
     *
     * @param min lowest value, in its unit
     * @param max highest value, in its unit
     * @return a new description
     */
    public Parameter within(double min, double max) {
        return new Parameter(
                name, kind, unit, new Range(min, max), whole, choices, readable, writable, moves, extras, help);
    }

    /**
     * Returns the same parameter for whole numbers only.
     *
     * @return a new description
     */
    public Parameter inWholes() {
        return new Parameter(name, kind, unit, range, true, choices, readable, writable, moves, extras, help);
    }

    /**
     * Returns the same parameter with a further optional value behind it.
     *
     * @param extra its description
     * @return a new description
     */
    public Parameter with(Parameter extra) {
        List<Parameter> more = new ArrayList<>(extras);
        more.add(extra);
        return new Parameter(name, kind, unit, range, whole, choices, readable, writable, moves, more, help);
    }

    /**
     * Returns the same parameter under another name.
     *
     * @param other the new name
     * @return a new description
     */
    public Parameter renamed(String other) {
        return new Parameter(other, kind, unit, range, whole, choices, readable, writable, moves, extras, help);
    }

    /**
     * Returns this parameter with another kind of access.
     *
     * @param read whether it can be read
     * @param write whether it can be set
     * @param moving whether setting it moves the robot
     * @return the same otherwise
     */
    public Parameter access(boolean read, boolean write, boolean moving) {
        return new Parameter(name, kind, unit, range, whole, choices, read, write, moving, extras, help);
    }

    /**
     * Brings a given value into the form this parameter holds: a bare number gets its unit, a word becomes the flag or
     * choice it means.
     *
     * @param given a value as typed or as handed in by a program
     * @return the value, of this parameter's kind and in its unit
     * @throws ParameterException if the value is of another kind or unit, outside of the range, or a fraction of what
     *     is counted in wholes; the message contains what would be right
     */
    public Value fit(Value given) {
        return switch (kind) {
            case NUMBER, LIST -> fitNumber(given);
            case YES_NO -> Value.yesNo(fitFlag(given));
            case ON_OFF -> Value.onOff(fitFlag(given));
            case CHOICE -> Value.text(fitChoice(given));
            case TEXT -> Value.text(given.toString());
        };
    }

    private Value fitNumber(Value given) {
        if (!(given instanceof Value.Number number)) {
            throw wrong(given, notANumber(given.toString()));
        }
        double amount = convert(number);
        if (!range.contains(amount)) {
            throw wrong(shown(number, amount), "outside " + range + symbol());
        }
        return Value.of(whole ? toWhole(given, amount) : amount, unit);
    }

    private String notANumber(String given) {
        Matcher decimalComma = DECIMAL_COMMA.matcher(given);
        return decimalComma.matches()
                ? "a number has a decimal point; write " + decimalComma.replaceFirst("$1.$2")
                : "not a number" + inUnit();
    }

    /** In the unit of the range, so that both can be compared; a number without unit stays as it was given. */
    private String shown(Value.Number given, double amount) {
        return given.unit() == Unit.NONE
                ? given.toString()
                : BigDecimal.valueOf(amount)
                                .setScale(6, RoundingMode.HALF_UP)
                                .stripTrailingZeros()
                                .toPlainString()
                        + symbol();
    }

    private String symbol() {
        return unit == Unit.NONE ? "" : " " + unit.symbol();
    }

    private double toWhole(Value given, double amount) {
        double nearest = Math.rint(amount);
        if (Math.abs(amount - nearest) > CONVERSION_ERROR) {
            throw wrong(given, "not a whole number");
        }
        return nearest;
    }

    private double convert(Value.Number number) {
        if (number.unit() == unit || number.unit() == Unit.NONE) {
            return number.amount();
        }
        if (number.unit() == Unit.S && unit == Unit.MS) {
            return number.amount() * 1000;
        }
        if (number.unit() == Unit.MS && unit == Unit.S) {
            return number.amount() / 1000;
        }
        throw wrong(number, unit == Unit.NONE ? "it is a plain number, without unit" : "not in " + unit.symbol());
    }

    private boolean fitFlag(Value given) {
        if (given instanceof Value.Flag flag) {
            return flag.yes();
        }
        return switch (given.toString().toLowerCase(Locale.ROOT)) {
            case "on", "yes", "true", "1" -> true;
            case "off", "no", "false", "0" -> false;
            default -> throw wrong(given, kind == Kind.ON_OFF ? "it is on or off" : "it is yes or no");
        };
    }

    private String fitChoice(Value given) {
        return choices.stream()
                .filter(choice -> choice.equalsIgnoreCase(given.toString()))
                .findFirst()
                .orElseThrow(() -> wrong(given, "it is one of " + String.join(", ", choices)));
    }

    private String inUnit() {
        return unit == Unit.NONE ? "" : " in " + unit.symbol();
    }

    private ParameterException wrong(@Nullable Object given, String why) {
        return new ParameterException(name, name + " " + given + ": " + why);
    }
}
