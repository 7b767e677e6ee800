package majicsim.pioneer.session;

import majicsim.pioneer.report.ConfigReport;

/** Barks once when no packet came for 2 s (ARCOS sheet 5.3). */
final class Watchdog {
    private static final long LIMIT_NANOS = ConfigReport.WATCHDOG_MS * 1_000_000L;

    private long silentNanos;
    private boolean barked;

    /** A valid packet came; returns whether the watchdog had stopped the robot meanwhile. */
    boolean pat() {
        boolean had = barked;
        silentNanos = 0;
        barked = false;
        return had;
    }

    boolean hasBarked() {
        return barked;
    }

    /** Time passes; returns true in the one step in which the robot must be stopped. */
    boolean step(long nanos) {
        silentNanos += nanos;
        boolean barks = !barked && silentNanos >= LIMIT_NANOS;
        barked |= barks;
        return barks;
    }
}
