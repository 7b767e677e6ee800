package majic.hemisson.line;

/**
 * Whether the line may be used again after an error: when it has been quiet for a while (Hemisson sheet 4.6), or after
 * a time limit, because noise must not delay a stop for ever. Guarded by its owner.
 */
final class LineRecovery {
    /** How long the line must have been quiet, ns. */
    static final long QUIET_NANOS = 100_000_000;

    /** The time limit: what is still received then answers no question, ns. */
    static final long LONGEST_NANOS = 1_000_000_000;

    private long receivedNanos;
    private long beganNanos;
    private boolean recovering;

    LineRecovery(long nowNanos) {
        receivedNanos = nowNanos;
    }

    /** Records that bytes were received. */
    void bytesReceived(long nowNanos) {
        receivedNanos = nowNanos;
    }

    /** Begins to wait for a quiet line. */
    void begin(long nowNanos) {
        recovering = true;
        beganNanos = nowNanos;
    }

    /** Whether nothing was received for a while. */
    boolean isQuiet(long nowNanos) {
        return nowNanos - receivedNanos >= QUIET_NANOS;
    }

    boolean isOver(long nowNanos) {
        recovering = recovering && !isQuiet(nowNanos) && nowNanos - beganNanos < LONGEST_NANOS;
        return !recovering;
    }
}
