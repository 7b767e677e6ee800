package majic.aibo.body;

/**
 * A gait at a pace. Immutable.
 *
 * @param gait which one
 * @param cycleMs how long the legs take for one cycle; the stick's usual is {@value #USUAL_CYCLE_MS} (URBI sheet 15)
 * @param msPerUnit how long this dog takes for a mm or a degree at that pace
 */
public record Stride(Gait gait, int cycleMs, double msPerUnit) {
    static final int USUAL_CYCLE_MS = 1000;

    /**
     * The fastest cycle that is known to have carried a real dog (URBI sheet 15, "Calibration"); above it feet slip.
     */
    static final int FASTEST_CYCLE_MS = 650;

    /** Slower legs would carry it no better; it stands on two of them for over a second then. */
    static final int SLOWEST_CYCLE_MS = 2500;

    /** How fast it goes, mm/s or deg/s, always positive. */
    public double unitsPerSecond() {
        return 1000 / msPerUnit;
    }

    /** How long it would take for a mm or a degree if its legs went at the usual pace. */
    public double usualMsPerUnit() {
        return msPerUnit * USUAL_CYCLE_MS / cycleMs;
    }

    /** What sets the pace on the dog, to be sent right before the gait. */
    String order() {
        return gait.paceVariable() + " = " + cycleMs + ";";
    }
}
