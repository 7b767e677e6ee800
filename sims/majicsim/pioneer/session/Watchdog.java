package majicsim.pioneer.session;

/** Expires once when no packet came for a time, by the factory setting 2 s (ARCOS sheet 5.3). */
final class Watchdog {
    private final long limitNanos;
    private long silentNanos;
    private boolean expired;

    /** Expires after so many milliseconds; never if it is 0. */
    Watchdog(int limitMs) {
        limitNanos = limitMs == 0 ? Long.MAX_VALUE : limitMs * 1_000_000L;
    }

    /** Reports a valid packet; returns whether the watchdog had stopped the robot before. */
    boolean reset() {
        boolean had = expired;
        silentNanos = 0;
        expired = false;
        return had;
    }

    boolean hasExpired() {
        return expired;
    }

    /** The time until it expires, ns; without end once it has. */
    long restNanos() {
        return expired ? Long.MAX_VALUE : limitNanos - silentNanos;
    }

    /** Lets time pass; returns true in the one step in which the robot must be stopped. */
    boolean step(long nanos) {
        silentNanos += nanos;
        boolean expires = !expired && silentNanos >= limitNanos;
        expired |= expires;
        return expires;
    }
}
