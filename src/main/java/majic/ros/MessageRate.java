package majic.ros;

/** Messages per second, from a count that only rises. Thread-safe. */
final class MessageRate {
    private static final double WINDOW_S = 1;

    private long baseCount;
    private long baseNanos;
    private double perSec;
    private boolean begun;

    /**
     * Takes the count of a moment.
     *
     * @param count all messages so far; fewer than before on a new connection
     * @param nanos the time
     * @return messages per second in the last whole second or longer; 0 in the first one
     */
    synchronized double at(long count, long nanos) {
        double seconds = (nanos - baseNanos) / 1e9;
        if (!begun || count < baseCount) {
            begun = true;
            perSec = 0;
            begin(count, nanos);
        } else if (seconds >= WINDOW_S) {
            perSec = (count - baseCount) / seconds;
            begin(count, nanos);
        }
        return perSec;
    }

    private void begin(long count, long nanos) {
        baseCount = count;
        baseNanos = nanos;
    }
}
