package majic.bot;

/** The units numbers are shown in, one for each dimension (MAJIC Script, "A line"), and plain counts. */
public enum Unit {
    /** A plain number: a count, a raw reading. */
    NONE(""),
    /** Millimetres. */
    MM("mm"),
    /** Degrees, counterclockwise positive. */
    DEG("deg"),
    /** Millimetres a second. */
    MM_PER_S("mm/s"),
    /** Degrees a second, counterclockwise positive. */
    DEG_PER_S("deg/s"),
    /** Seconds. */
    S("s"),
    /** Milliseconds; only what is short by nature is shown in them, such as the age of a reading. */
    MS("ms"),
    /** Volts. */
    V("V"),
    /** Hundredths. */
    PERCENT("%");

    private final String symbol;

    Unit(String symbol) {
        this.symbol = symbol;
    }

    /**
     * How the unit is written behind a number.
     *
     * @return the symbol, empty for a plain number
     */
    public String symbol() {
        return symbol;
    }
}
