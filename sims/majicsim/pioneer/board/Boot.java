package majicsim.pioneer.board;

/**
 * Whether the controller receives anything: not while it restarts, and not in maintenance mode, which only a reset
 * ends.
 */
final class Boot {
    private static final long RESTART_NANOS = 1_000_000_000L;

    private long restartNanos;
    private boolean maintenance;
    private long upNanos;

    /** RESET, or the button for it. */
    void restart() {
        maintenance = false;
        restartNanos = RESTART_NANOS;
        upNanos = 0;
    }

    /** MAINTENANCE. */
    void maintain() {
        maintenance = true;
    }

    void step(long nanos) {
        restartNanos = Math.max(0, restartNanos - nanos);
        upNanos += nanos;
    }

    boolean isListening() {
        return restartNanos == 0 && !maintenance;
    }

    /** The controller's clock: microseconds since it started, in 32 bits. */
    int clockMicros() {
        return (int) (upNanos / 1000);
    }
}
