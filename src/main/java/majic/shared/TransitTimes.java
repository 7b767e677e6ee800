package majic.shared;

import java.util.concurrent.TimeUnit;

/**
 * How long the messages of one desk are on their way, compared with the fastest of them. The clocks of the two
 * computers are not compared, only how the difference between them changes. Used by the thread of the broker's
 * connection.
 */
final class TransitTimes {
    /** Clocks of computers differ by less than this part of the time. */
    private static final double DRIFT = 1e-4;

    private boolean begun;
    private long smallestNanos;
    private long lastNanos;

    /**
     * Returns by how much a message is later than the fastest one.
     *
     * @param sentMs when it was written, on the clock of the desk
     * @param arrivedNanos when it arrived, on the clock of this program
     * @return zero or more, ns
     */
    long lateNanos(long sentMs, long arrivedNanos) {
        long difference = arrivedNanos - TimeUnit.MILLISECONDS.toNanos(sentMs);
        smallestNanos += begun ? Math.round((arrivedNanos - lastNanos) * DRIFT) : 0;
        if (!begun || difference < smallestNanos) {
            smallestNanos = difference;
        }
        begun = true;
        lastNanos = arrivedNanos;
        return difference - smallestNanos;
    }
}
