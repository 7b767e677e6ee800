package majic.pioneer.session;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Detects that the computer was suspended. On Linux and macOS {@link System#nanoTime} stops meanwhile, so minutes without a
 * packet would go unnoticed, and the robot, stopped by its watchdog, would resume its last speed at the next packet (ARCOS
 * sheet 5.3). The wall clock goes on. Thread-safe.
 */
final class SuspendDetector {
    /** More than a usual correction of the wall clock between two packets, less than the robot's watchdog, ms. */
    private static final long LONGEST_MS = 1000;

    private final LongSupplier wallMs;
    private final LongSupplier nanos;
    private long aheadMs;

    SuspendDetector() {
        this(System::currentTimeMillis, System::nanoTime);
    }

    SuspendDetector(LongSupplier wallMs, LongSupplier nanos) {
        this.wallMs = wallMs;
        this.nanos = nanos;
        this.aheadMs = wallAheadMs();
    }

    /** Whether the computer was suspended since the last call. */
    synchronized boolean wasSuspended() {
        long before = aheadMs;
        aheadMs = wallAheadMs();
        return aheadMs - before > LONGEST_MS;
    }

    private long wallAheadMs() {
        return wallMs.getAsLong() - TimeUnit.NANOSECONDS.toMillis(nanos.getAsLong());
    }
}
