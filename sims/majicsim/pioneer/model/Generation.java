package majicsim.pioneer.model;

/**
 * The generations of controller firmware, oldest first. Packets have only ever grown at their ends (ARCOS sheet 8, 10),
 * so a generation is recognised by where its packets stop.
 */
public enum Generation {
    /** Pioneer 2: the SIP ends at DIGOUT, CONFIG at TRANSKI. */
    P2OS,
    /** Pioneer 3 before the SH controllers: the SIP ends at the state of charge, CONFIG at the charge threshold. */
    AROS,
    /** SH controllers and later: everything in the sheet. */
    ARCOS;

    public boolean isAtLeast(Generation other) {
        return compareTo(other) >= 0;
    }
}
