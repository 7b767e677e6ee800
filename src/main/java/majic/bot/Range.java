package majic.bot;

/**
 * The numbers a parameter may have, both ends included. Immutable.
 *
 * @param min the lowest, in the parameter's unit
 * @param max the highest, in the parameter's unit
 */
public record Range(double min, double max) {
    /** Every finite number. */
    public static final Range ANY = new Range(-Double.MAX_VALUE, Double.MAX_VALUE);

    /** Checks that the range holds something. */
    public Range {
        if (!(min <= max)) {
            throw new IllegalArgumentException("a range runs from low to high: " + min + ", " + max);
        }
    }

    /**
     * Returns whether a number lies inside.
     *
     * @param number in the parameter's unit
     * @return false also for what is not a number
     */
    public boolean contains(double number) {
        return number >= min && number <= max;
    }

    /**
     * Returns the nearest number inside.
     *
     * @param number in the parameter's unit
     * @return the number itself, or the end that it passed
     */
    public double clamp(double number) {
        return Math.max(min, Math.min(max, number));
    }

    /** Returns the text of the range in messages: {@code -91 … 91}. */
    @Override
    public String toString() {
        return Value.plain(min) + " … " + Value.plain(max);
    }
}
