package majicsim.hemisson.options;

/** The two makers' versions of the firmware. */
public enum Dialect {
    /** HemiOS 1.50 as K-Team ships it. */
    KTEAM,
    /** HemiOS 1.50-RNe, as RoadNarrows sold it (sheet 10). */
    ROADNARROWS
}
