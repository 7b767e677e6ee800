package majic.pioneer.session;

/**
 * The speeds a Pioneer's serial port may be found at: what it has after power-up, then what a session before may have
 * left it at (ARCOS sheet 1, 6.1). For the thread that connects.
 */
public final class BaudRates {
    /** After power-up, baud. */
    public static final int POWER_UP = 9600;

    /** HOSTBAUD's code of {@link #POWER_UP}. */
    static final int POWER_UP_CODE = 0;

    /** What a robot that allows it is set to, baud. */
    static final int FAST = 38_400;

    /** HOSTBAUD's code of {@link #FAST}. */
    static final int FAST_CODE = 2;

    private static final int[] LIKELIEST_FIRST = {POWER_UP, FAST, 115_200, 57_600, 19_200};

    private final ArcosLine line;
    private int index;

    BaudRates(ArcosLine line) {
        this.line = line;
    }

    /**
     * Goes on to the next speed, and after the last to the first again.
     *
     * @return false, with nothing done, if the line is no serial port
     */
    boolean next() {
        int following = (index + 1) % LIKELIEST_FIRST.length;
        if (!line.setBaud(LIKELIEST_FIRST[following])) {
            return false;
        }
        index = following;
        return true;
    }

    /** What the port is set to now, baud. */
    int now() {
        return LIKELIEST_FIRST[index];
    }
}
