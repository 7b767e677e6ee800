package majic.time;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Detects that the computer was suspended. On Linux and macOS {@link System#nanoTime} stops meanwhile, so by that clock
 * a suspended program has not lost any time; the wall clock goes on. Thread-safe.
 */
public final class SuspendDetector {
    /** More than a usual correction of the wall clock between two calls, less than the watchdogs of robots, ms. */
    private static final long LONGEST_MS = 1000;

    private final LongSupplier wallMs;
    private final LongSupplier nanos;
    private long aheadMs;

    /** Creates a detector that begins to watch now. */
    public SuspendDetector() {
        this(System::currentTimeMillis, System::nanoTime);
    }

    SuspendDetector(LongSupplier wallMs, LongSupplier nanos) {
        this.wallMs = wallMs;
        this.nanos = nanos;
        this.aheadMs = wallAheadMs();
    }

    /** Whether the computer was suspended for more than a second since the last call. */
    public synchronized boolean wasSuspended() {
        long before = aheadMs;
        aheadMs = wallAheadMs();
        return aheadMs - before > LONGEST_MS;
    }

    private long wallAheadMs() {
        return wallMs.getAsLong() - TimeUnit.NANOSECONDS.toMillis(nanos.getAsLong());
    }
}
