package majic.pioneer.state;

import majic.pioneer.arcos.SipTail;

/** What the charger does to the battery (ARCOS sheet 8, CHARGESTATE). */
public enum Charging {
    /** Not charging. */
    NONE("not charging"),
    /** As much current as there is. */
    BULK("bulk"),
    /** Held at the highest voltage. */
    OVERCHARGE("overcharge"),
    /** Full, and kept so. */
    FLOAT("float"),
    /** The cells are brought to the same level. */
    BALANCE("balance"),
    /** The robot cannot tell. */
    UNKNOWN("unknown");

    private final String words;

    Charging(String words) {
        this.words = words;
    }

    /** Codes that are not in the sheet count as unknown. */
    static Charging of(SipTail tail) {
        int code = tail.chargeState();
        return code >= 0 && code < UNKNOWN.ordinal() ? values()[code] : UNKNOWN;
    }

    /** For people. */
    public String words() {
        return words;
    }

    /** Whether current flows into the battery. */
    public boolean isCharging() {
        return this != NONE && this != UNKNOWN;
    }
}
