package majic.server;

import java.util.function.LongSupplier;

/** Limits events to a number per second; what was not used is saved up to a limit. Used by one thread. */
final class Rate {
    private final int most;
    private final double perSecond;
    private final LongSupplier nanos;
    private double allowed;
    private long lastNanos;

    /**
     * Creates a full allowance.
     *
     * @param most events that may come at once, at least 1
     * @param perSecond events a second in the long run, more than zero
     * @param nanos a clock that never goes back
     */
    Rate(int most, double perSecond, LongSupplier nanos) {
        this.most = most;
        this.perSecond = perSecond;
        this.nanos = nanos;
        this.allowed = most;
        this.lastNanos = nanos.getAsLong();
    }

    /** Creates a full allowance for a second. */
    Rate(int perSecond, LongSupplier nanos) {
        this(perSecond, perSecond, nanos);
    }

    /** Takes one event from the allowance; returns false if none is left. */
    boolean take() {
        if (!hasOne()) {
            return false;
        }
        allowed--;
        return true;
    }

    /** Returns whether an event is left. */
    boolean hasOne() {
        long now = nanos.getAsLong();
        allowed = Math.min(most, allowed + (now - lastNanos) / 1e9 * perSecond);
        lastNanos = now;
        return allowed >= 1;
    }
}
