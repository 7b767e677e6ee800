package majic.aibo.sound;

/**
 * How loud sounds are that are sent over. The dog has no setting for that (URBI sheet 13), so their samples are made
 * smaller before they go out. Safe from any thread.
 */
public final class Volume {
    public static final double FULL_PERCENT = 100;

    private volatile double percent = FULL_PERCENT;

    public double percent() {
        return percent;
    }

    public void set(double newPercent) {
        percent = newPercent;
    }

    /** What samples are to be multiplied with. */
    double share() {
        return percent / FULL_PERCENT;
    }
}
