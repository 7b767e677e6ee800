package majic.pioneer.session;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Notices that the computer has slept. The clock that programs wait by stands still meanwhile on Linux and macOS, so a
 * silence of minutes looks like none, and the robot, stopped by its watchdog, would take up its last speed at the next
 * packet (ARCOS sheet 5.3). The clock on the wall goes on. Thread-safe.
 */
final class SuspendDetector {
    /** More than any correction of the wall's clock between two packets, less than the robot's watchdog, ms. */
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

    /** Whether the computer has slept since the last time somebody asked. */
    synchronized boolean isOver() {
        long before = aheadMs;
        aheadMs = wallAheadMs();
        return aheadMs - before > LONGEST_MS;
    }

    private long wallAheadMs() {
        return wallMs.getAsLong() - TimeUnit.NANOSECONDS.toMillis(nanos.getAsLong());
    }
}
