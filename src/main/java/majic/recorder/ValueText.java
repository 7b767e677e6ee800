package majic.recorder;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.text.VisibleText;

/** The form of values and times in a recording: numbers without unit, and with no more digits than sensors have. */
final class ValueText {
    /** Precedes the reason why there is no value. */
    private static final String UNKNOWN = "?";

    /** Separates the items of a list. */
    private static final String BETWEEN = ", ";

    private static final int MOST_EXACT = 15;
    private static final double[] TENS = {1, 10, 100, 1000, 10_000, 100_000};
    private static final int MOST_DIGITS = 25;

    /** Units with more digits behind the point are those of a place on the earth. */
    private static final int USUAL_DIGITS = 3;

    private ValueText() {}

    /** A value as text without tabs and line ends. */
    static String of(Value value) {
        if (value instanceof Value.Number number) {
            int digits = number.unit().digits();
            return digits > USUAL_DIGITS ? plain(number.amount(), digits) : of(number.amount());
        }
        if (value instanceof Value.Many many) {
            return many.values().stream().map(ValueText::of).collect(Collectors.joining(BETWEEN));
        }
        return VisibleText.of(value instanceof Value.Unknown unknown ? UNKNOWN + unknown.reason() : value.toString());
    }

    /** A latitude needs all the digits of its unit. */
    private static String plain(double number, int digits) {
        BigDecimal rounded = BigDecimal.valueOf(number).setScale(digits, RoundingMode.HALF_UP);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }

    /** The text of a number with all its digits. */
    static String plain(double number) {
        return BigDecimal.valueOf(number).toPlainString();
    }

    /** A number with four digits or more, as far as they are not zero. */
    static String of(double number) {
        if (number == Math.rint(number) && Math.abs(number) < 1e15) {
            return Long.toString((long) number);
        }
        int digits = decimals(number);
        long scaled = Math.round(number * Math.pow(10, digits));
        return scaled == 0
                ? "0"
                : BigDecimal.valueOf(scaled, digits).stripTrailingZeros().toPlainString();
    }

    /** A place or an angle, with four decimal places as far as they are not zero. */
    static String fine(double number) {
        long scaled = Math.round(number * 1e4);
        return scaled == 0
                ? "0"
                : BigDecimal.valueOf(scaled, 4).stripTrailingZeros().toPlainString();
    }

    private static int decimals(double number) {
        double size = Math.abs(number);
        return size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 5;
    }

    /**
     * The number of which {@link #of(double)} makes exactly this text; NaN if there is none. Much faster than trying.
     */
    static double exact(String text) {
        int first = text.startsWith("-") ? 1 : 0;
        int point = text.indexOf('.');
        int end = text.length();
        int decimals = point < 0 ? 0 : end - point - 1;
        boolean padded = text.startsWith("0", first) && end > first + 1 && point != first + 1;
        if (end == first || end > MOST_EXACT || padded || point == first || decimals > 5 || point == end - 1) {
            return Double.NaN;
        }
        long digits = 0;
        for (int at = first; at < end; at++) {
            int digit = text.charAt(at) - '0';
            if (at != point && (digit < 0 || digit > 9)) {
                return Double.NaN;
            }
            digits = at == point ? digits : 10 * digits + digit;
        }
        double number = (first == 1 ? -digits : digits) / TENS[decimals];
        boolean trailing = decimals > 0 && digits % 10 == 0;
        boolean minusZero = first == 1 && digits == 0;
        return trailing || minusZero || decimals > decimals(number) ? Double.NaN : number;
    }

    /** A time in seconds, with three decimal places. */
    static String time(double seconds) {
        return BigDecimal.valueOf(Math.round(seconds * 1000), 3).toPlainString();
    }

    /** The value that a text stands for. */
    static Value value(String text, Parameter parameter, boolean about) {
        if (text.startsWith(UNKNOWN)) {
            return Value.unknown(text.substring(UNKNOWN.length()));
        }
        return switch (parameter.kind()) {
            case NUMBER -> number(text, parameter, about);
            case YES_NO -> Value.yesNo(text.equals("yes"));
            case ON_OFF -> Value.onOff(text.equals("on"));
            case LIST ->
                Value.many(
                        items(text).map(item -> number(item, parameter, about)).toList());
            case CHOICE, TEXT -> Value.text(text);
        };
    }

    /** The number in one item of a list, NaN if there is none. */
    static double amount(String text, int item) {
        return items(text).skip(item).findFirst().map(ValueText::amount).orElse(Double.NaN);
    }

    private static Stream<String> items(String text) {
        return Stream.of(text.split(BETWEEN));
    }

    private static Value number(String text, Parameter parameter, boolean about) {
        double amount = parsed(text);
        if (Double.isFinite(amount)) {
            return new Value.Number(amount, parameter.unit(), about);
        }
        return text.equals("clear") ? Value.CLEAR : Value.text(text);
    }

    /** The number that a text stands for: 1 and 0 for flags, infinity for clear, NaN for all else. */
    static double amount(String text) {
        return switch (text) {
            case "yes", "on" -> 1;
            case "no", "off" -> 0;
            case "clear" -> Double.POSITIVE_INFINITY;
            default -> parsed(text);
        };
    }

    private static double parsed(String text) {
        if (text.isEmpty() || text.length() > MOST_DIGITS || "+-.0123456789".indexOf(text.charAt(0)) < 0) {
            return Double.NaN;
        }
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
