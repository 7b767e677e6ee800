package majic.server;

import java.util.function.LongSupplier;

/** Allows so many lines a second, and as many at once after a second without any. Used by one thread. */
final class LineRate {
    private final int perSecond;
    private final LongSupplier nanos;
    private double allowed;
    private long lastNanos;

    /**
     * A full allowance.
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

    /** Takes one line from the allowance; false if there is none. */
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
