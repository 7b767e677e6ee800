package majic.gui.plot.data;

/**
 * A range of time, in seconds on the clock of the plot's source, or of values. Immutable.
 *
 * @param from lower end
 * @param to upper end, greater than {@code from}
 */
public record Span(double from, double to) {
    /** The part of the range of values that stays empty above and below a curve. */
    private static final double MARGIN = 0.05;

    /** Of the values themselves: recorded numbers have four digits. */
    private static final double LEAST_MARGIN = 0.001;

    /** About how many steps the ends of an axis are rounded to. */
    private static final double STEPS = 20;

    public double length() {
        return to - from;
    }

    /** Returns the range magnified around a number that keeps its place. */
    public Span scaled(double factor, double around) {
        return new Span(around + (from - around) * factor, around + (to - around) * factor);
    }

    /** Returns the part of this range between two shares of it, in any order, 0 to 1. */
    public Span part(double share, double otherShare) {
        return new Span(from + length() * Math.min(share, otherShare), from + length() * Math.max(share, otherShare));
    }

    /**
     * Returns the range of an axis that shows values with some room above and below, with round ends, so that it
     * changes seldom. Differences that a recording does not keep, of less than a thousandth, fill only a part of it.
     *
     * @param least the lowest value
     * @param greatest the highest value, not below {@code least}
     */
    public static Span ofAxis(double least, double greatest) {
        double length = greatest - least;
        double magnitude = Math.max(Math.abs(least), Math.abs(greatest));
        double room =
                length > 0 ? Math.max(length * MARGIN, magnitude * LEAST_MARGIN) : Math.max(1, magnitude * MARGIN);
        double step = round((length + 2 * room) / STEPS);
        return new Span(step * Math.floor((least - room) / step), step * Math.ceil((greatest + room) / step));
    }

    /** Returns 1, 2 or 5 times a power of ten, the next above a number. */
    private static double round(double number) {
        double power = Math.pow(10, Math.floor(Math.log10(number)));
        double first = number / power;
        return power * (first <= 1 ? 1 : first <= 2 ? 2 : first <= 5 ? 5 : 10);
    }
}
