package majic.bot;

/** The units numbers are shown in, one for each dimension (MAJIC Script, "A line"), and plain counts. */
public enum Unit {
    /** A plain number: a count, a raw reading. */
    NONE("", 3),
    /** Millimetres. */
    MM("mm", 1),
    /** Degrees, counterclockwise positive. */
    DEG("deg", 1),
    /** Millimetres a second. */
    MM_PER_S("mm/s", 1),
    /** Degrees a second, counterclockwise positive. */
    DEG_PER_S("deg/s", 1),
    /** Millimetres a second, gained or lost each second. */
    MM_PER_S2("mm/s²", 0),
    /** Degrees a second, gained or lost each second. */
    DEG_PER_S2("deg/s²", 0),
    /** Seconds. */
    S("s", 2),
    /** Milliseconds; only what is short by nature is shown in them, such as the age of a reading. */
    MS("ms", 0),
    /** Volts. */
    V("V", 2),
    /** Hundredths. */
    PERCENT("%", 1),
    /** Degrees of Celsius' scale. */
    CELSIUS("°C", 1),
    /** Degrees of latitude or longitude, to about 10 mm. */
    LAT_LON("°", 7);

    private final String symbol;
    private final int digits;

    Unit(String symbol, int digits) {
        this.symbol = symbol;
        this.digits = digits;
    }

    /**
     * Returns the text of the unit behind a number.
     *
     * @return the symbol, empty for a plain number
     */
    public String symbol() {
        return symbol;
    }

    /**
     * Returns the number of decimals in an answer; further decimals are not significant for a robot.
     *
     * @return the most digits behind the point
     */
    public int digits() {
        return digits;
    }
}
