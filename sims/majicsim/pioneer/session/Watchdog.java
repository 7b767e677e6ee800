package majicsim.pioneer.session;

import majicsim.pioneer.report.ConfigReport;

/** Expires once when no packet came for 2 s (ARCOS sheet 5.3). */
final class Watchdog {
    private static final long LIMIT_NANOS = ConfigReport.WATCHDOG_MS * 1_000_000L;

    private long silentNanos;
    private boolean expired;

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
        return expired ? Long.MAX_VALUE : LIMIT_NANOS - silentNanos;
    }

    /** Lets time pass; returns true in the one step in which the robot must be stopped. */
    boolean step(long nanos) {
        silentNanos += nanos;
        boolean expires = !expired && silentNanos >= LIMIT_NANOS;
        expired |= expires;
        return expires;
    }
}
