package majic.pioneer.state;

/** The state of charging (ARCOS sheet 8, CHARGESTATE). */
public enum Charging {
    /** Not charging. */
    NONE("not charging"),
    /** Highest current. */
    BULK("bulk"),
    /** Highest voltage. */
    OVERCHARGE("overcharge"),
    /** Full; the charge is maintained. */
    FLOAT("float"),
    /** Equalises the cells. */
    BALANCE("balance"),
    /** Not reported. */
    UNKNOWN("unknown");

    private final String words;

    Charging(String words) {
        this.words = words;
    }

    /** Codes that are not in the sheet count as unknown. */
    static Charging of(int code) {
        return code >= 0 && code < UNKNOWN.ordinal() ? values()[code] : UNKNOWN;
    }

    /** The value of parameter "charging". */
    public String words() {
        return words;
    }

    /** Whether current flows into the battery. */
    public boolean isCharging() {
        return this != NONE && this != UNKNOWN;
    }
}
