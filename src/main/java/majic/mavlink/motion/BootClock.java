package majic.mavlink.motion;

/**
 * When the reports of an autopilot were made, by its own clock. A radio or a connection that is congested delivers them
 * late; those that came fastest are taken to have come at once. For one thread.
 */
final class BootClock {
    private static final long NANOS_PER_MS = 1_000_000;

    /**
     * More than the clock of a simulation on a busy computer lags, less than the delay of a congested connection grows.
     */
    private static final double DRIFT = 0.05;

    /** The clock goes back by more than this when the autopilot restarts, ms: frames may overtake each other. */
    private static final long RESTART_MS = 500;

    private long newestMs = Long.MAX_VALUE;
    private long offsetNanos;
    private long newestNanos;

    /**
     * Returns when a report was made.
     *
     * @param bootMs the time in it, ms since the start of the autopilot; 0 if it has none
     * @param nowNanos when it arrived
     * @return on the clock of the arrivals, not later than it
     */
    long measuredNanos(long bootMs, long nowNanos) {
        if (bootMs == 0) {
            return nowNanos;
        }
        long offset = nowNanos - bootMs * NANOS_PER_MS;
        boolean restarted = bootMs < newestMs - RESTART_MS;
        offsetNanos = restarted ? offset : Math.min(offset, offsetNanos + (long) (DRIFT * (nowNanos - newestNanos)));
        newestNanos = nowNanos;
        newestMs = bootMs;
        return bootMs * NANOS_PER_MS + offsetNanos;
    }
}
