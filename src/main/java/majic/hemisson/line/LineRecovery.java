package majic.hemisson.line;

/**
 * Whether the line may be used again after something went wrong: when it has been quiet for a while (Hemisson sheet 4.6),
 * or when it would not be quiet anyway, since noise must not hold up a stop for ever. Guarded by its owner.
 */
final class LineRecovery {
    /** How long the line must have been quiet, ns. */
    static final long QUIET_NANOS = 100_000_000;

    /** Who still talks after so long does not answer anybody, ns. */
    static final long LONGEST_NANOS = 1_000_000_000;

    private long heardNanos;
    private long beganNanos;
    private boolean settling;

    LineRecovery(long nowNanos) {
        heardNanos = nowNanos;
    }

    void heard(long nowNanos) {
        heardNanos = nowNanos;
    }

    void begin(long nowNanos) {
        settling = true;
        beganNanos = nowNanos;
    }

    /** Whether nothing has come in for a while. */
    boolean isQuiet(long nowNanos) {
        return nowNanos - heardNanos >= QUIET_NANOS;
    }

    boolean isOver(long nowNanos) {
        settling = settling && !isQuiet(nowNanos) && nowNanos - beganNanos < LONGEST_NANOS;
        return !settling;
    }
}
