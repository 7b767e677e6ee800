package majic.bot;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The value of a parameter: a number with its unit, a yes or no, a word, "nothing in range", or the reason why it is
 * not available. Immutable; {@code toString()} is how answers show it.
 */
public sealed interface Value {

    /** Nothing is in range: greater than any number in a comparison. */
    Value CLEAR = new Clear();

    /**
     * A number.
     *
     * @param amount finite, in the given unit
     * @param unit what it counts
     * @param about whether it is only an estimate, as on a robot without encoders
     */
    record Number(double amount, Unit unit, boolean about) implements Value {
        /** Refuses what is not a finite number; turns a negative zero into zero. */
        public Number {
            if (!Double.isFinite(amount)) {
                throw new IllegalArgumentException("not a finite number: " + amount);
            }
            amount += 0.0;
        }

        @Override
        public String toString() {
            String number = plain(amount, unit.digits());
            String shown = unit == Unit.NONE ? number : number + " " + unit.symbol();
            return about ? "about " + shown : shown;
        }
    }

    /**
     * A yes or a no.
     *
     * @param yes which of them
     * @param words how it is shown
     */
    record Flag(boolean yes, Words words) implements Value {
        /** How a flag is shown. */
        public enum Words {
            /** For what is so or is not: {@code yes}, {@code no}. */
            YES_NO,
            /** For what is switched: {@code on}, {@code off}. */
            ON_OFF
        }

        @Override
        public String toString() {
            return switch (words) {
                case YES_NO -> yes ? "yes" : "no";
                case ON_OFF -> yes ? "on" : "off";
            };
        }
    }

    /**
     * A word or a text.
     *
     * @param text as the robot reports it
     */
    record Text(String text) implements Value {
        @Override
        public String toString() {
            return text;
        }
    }

    /**
     * Several values that belong together, such as all sonar readings.
     *
     * @param values in the order of the robot's manual
     */
    record Many(List<Value> values) implements Value {
        /** Keeps a copy. */
        public Many {
            values = List.copyOf(values);
        }

        @Override
        public String toString() {
            return values.stream().map(Value::toString).collect(Collectors.joining(", "));
        }
    }

    /** The value of a distance when nothing is in range; there is one, {@link Value#CLEAR}. */
    record Clear() implements Value {
        @Override
        public String toString() {
            return "clear";
        }
    }

    /**
     * A value that cannot be had now.
     *
     * @param reason why, as half a sentence: "no reading yet"
     */
    record Unknown(String reason) implements Value {
        @Override
        public String toString() {
            return "unknown (" + reason + ")";
        }
    }

    /**
     * A measured number.
     *
     * @param amount finite
     * @param unit its unit
     * @return the value
     */
    static Value of(double amount, Unit unit) {
        return new Number(amount, unit, false);
    }

    /**
     * An estimated number, shown with "about".
     *
     * @param amount finite
     * @param unit its unit
     * @return the value
     */
    static Value about(double amount, Unit unit) {
        return new Number(amount, unit, true);
    }

    /**
     * A yes or no.
     *
     * @param yes which
     * @return the value
     */
    static Value yesNo(boolean yes) {
        return new Flag(yes, Flag.Words.YES_NO);
    }

    /**
     * An on or off.
     *
     * @param on which
     * @return the value
     */
    static Value onOff(boolean on) {
        return new Flag(on, Flag.Words.ON_OFF);
    }

    /**
     * A word or text.
     *
     * @param text any
     * @return the value
     */
    static Value text(String text) {
        return new Text(text);
    }

    /**
     * Several values.
     *
     * @param values in order
     * @return the value
     */
    static Value many(List<Value> values) {
        return new Many(values);
    }

    /**
     * A value that cannot be had.
     *
     * @param reason half a sentence
     * @return the value
     */
    static Value unknown(String reason) {
        return new Unknown(reason);
    }

    /**
     * Returns the number in this value.
     *
     * @return the amount in its unit; 1 and 0 for a flag; infinity for clear
     * @throws BotException if there is no number in it
     */
    default double number() {
        if (this instanceof Number number) {
            return number.amount();
        }
        if (this instanceof Flag flag) {
            return flag.yes() ? 1 : 0;
        }
        if (this instanceof Clear) {
            return Double.POSITIVE_INFINITY;
        }
        throw new BotException("not a number: " + this);
    }

    /**
     * Returns whether this value means yes or on.
     *
     * @return true only for a flag that is set
     */
    default boolean isYes() {
        return this instanceof Flag flag && flag.yes();
    }

    /**
     * A number for users: at most three digits behind the point, no trailing zeros, no exponent.
     *
     * @param number finite
     * @return for instance {@code 498}, {@code 12.5}, {@code 0.031}
     */
    static String plain(double number) {
        return plain(number, 3);
    }

    private static String plain(double number, int mostDigits) {
        if (!Double.isFinite(number)) {
            return String.valueOf(number);
        }
        int usual = Math.abs(number) >= 100 ? 0 : Math.abs(number) >= 10 ? 1 : 3;
        // A unit with more digits than any number usually has needs all of them.
        int digits = mostDigits > 3 ? mostDigits : usual;
        BigDecimal rounded = BigDecimal.valueOf(number)
                .setScale(Math.min(digits, mostDigits), RoundingMode.HALF_UP)
                .stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
