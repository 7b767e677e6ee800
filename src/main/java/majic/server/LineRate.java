package majic.server;

import java.util.function.LongSupplier;

/**
 * Limits lines to a number per second; after a second without any, the same number may come at once. Used by one
 * thread.
 */
final class LineRate {
    private final int perSecond;
    private final LongSupplier nanos;
    private double allowed;
    private long lastNanos;

    /**
     * Creates a full allowance.
     *
     * @param perSecond lines a second, at least 1
     * @param nanos a clock that never goes back
     */
    LineRate(int perSecond, LongSupplier nanos) {
        this.perSecond = perSecond;
        this.nanos = nanos;
        this.allowed = perSecond;
        this.lastNanos = nanos.getAsLong();
    }

    /** Takes one line from the allowance; returns false if none is left. */
    boolean take() {
        long now = nanos.getAsLong();
        allowed = Math.min(perSecond, allowed + (now - lastNanos) / 1e9 * perSecond);
        lastNanos = now;
        if (allowed < 1) {
            return false;
        }
        allowed--;
        return true;
    }
}
