package majic.text;

/**
 * Formats numbers for windows, with the minus sign {@value #MINUS}. Numbers in commands, answers, logs and files have a
 * hyphen instead, which can be typed. Thread-safe.
 */
public final class NumberText {
    private static final char MINUS = '\u2212';

    private NumberText() {}

    /**
     * Formats a number.
     *
     * @param number a number, or its text with a unit
     * @return its text; each hyphen is replaced by the minus sign
     */
    public static String of(Object number) {
        return String.valueOf(number).replace('-', MINUS);
    }

    /**
     * Formats an amount with its sign, rounded to a whole number.
     *
     * @param amount any number
     * @return for instance {@code +150}; zero has no sign, even if it results from rounding
     */
    public static String signed(double amount) {
        long rounded = Math.round(amount);
        return (rounded > 0 ? "+" : "") + of(rounded);
    }
}
