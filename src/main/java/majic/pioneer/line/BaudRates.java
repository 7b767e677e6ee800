package majic.pioneer.line;

/**
 * The speeds that a Pioneer's serial port may have: the one after power-up, then those that an earlier session may have
 * set (ARCOS sheet 1, 6.1). For the thread that connects.
 */
public final class BaudRates {
    /** After power-up, baud. */
    public static final int POWER_UP = 9600;

    /** HOSTBAUD's code of {@link #POWER_UP}. */
    static final int POWER_UP_CODE = 0;

    /** Set in robots that allow it, baud. */
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
     * Sets the next speed, and after the last the first again.
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

    /** The speed that is set now, baud. */
    int now() {
        return LIKELIEST_FIRST[index];
    }
}
