package majic.aibo.sound;

/**
 * The volume of sounds sent to the dog. The dog has no such setting (URBI sheet 13), so the samples are reduced before
 * they are sent. Thread-safe.
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
