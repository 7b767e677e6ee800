package majic.time;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Detects that the computer was suspended. On Linux and macOS {@link System#nanoTime} stops meanwhile, so by that clock
 * a suspended program has not lost any time; the wall clock goes on. It finds shorter suspensions when it is asked more
 * often, since the two clocks also drift apart by themselves. Thread-safe.
 */
public final class SuspendDetector {
    /** More than a usual correction of the wall clock between two calls, less than the watchdogs of robots, ms. */
    private static final long LONGEST_MS = 1000;

    /** The two clocks drift apart by this part of the time at most. */
    private static final double DRIFT = 500e-6;

    private final LongSupplier wallMs;
    private final LongSupplier nanos;
    private long askedNanos;
    private long aheadMs;

    /** Creates a detector that begins to watch now. */
    public SuspendDetector() {
        this(System::currentTimeMillis, System::nanoTime);
    }

    SuspendDetector(LongSupplier wallMs, LongSupplier nanos) {
        this.wallMs = wallMs;
        this.nanos = nanos;
        this.askedNanos = nanos.getAsLong();
        this.aheadMs = wallAheadMs();
    }

    /**
     * Returns whether the computer was suspended since the last call: for more than a second, and 2 s more for each
     * hour between the two calls.
     */
    public synchronized boolean wasSuspended() {
        long before = aheadMs;
        long beforeNanos = askedNanos;
        askedNanos = nanos.getAsLong();
        aheadMs = wallAheadMs();
        double driftMs = DRIFT * TimeUnit.NANOSECONDS.toMillis(askedNanos - beforeNanos);
        return aheadMs - before > LONGEST_MS + driftMs;
    }

    private long wallAheadMs() {
        return wallMs.getAsLong() - TimeUnit.NANOSECONDS.toMillis(nanos.getAsLong());
    }
}
