package majic.hemisson.line;

/**
 * How well the line works. Immutable.
 *
 * @param roundTripMs mean time from a question to its answer, ms; 0 before the first
 * @param answers how many questions were answered
 * @param misses how many were not, or not in time
 * @param repeats how many were asked once more
 * @param lastMissNanos when an answer was missed last; {@link Long#MIN_VALUE} if none was
 */
public record LinkQuality(double roundTripMs, long answers, long misses, long repeats, long lastMissNanos) {
    public static final LinkQuality NONE = new LinkQuality(0, 0, 0, 0, Long.MIN_VALUE);

    /** Whether an answer was missed at a moment or after it. */
    public boolean hasMissedSince(long nanos) {
        return misses > 0 && lastMissNanos >= nanos;
    }

    /** Counts answers. Guarded by its owner. */
    static final class Meter {
        private static final double WEIGHT_OF_NEWEST = 0.1;

        private double roundTripMs;
        private long answers;
        private long misses;
        private long repeats;
        private long lastMissNanos = Long.MIN_VALUE;

        void answered(long roundTripNanos) {
            double newestMs = roundTripNanos / 1e6;
            roundTripMs += answers == 0 ? newestMs : WEIGHT_OF_NEWEST * (newestMs - roundTripMs);
            answers++;
        }

        void missed(long nowNanos) {
            misses++;
            lastMissNanos = nowNanos;
        }

        void repeated() {
            repeats++;
        }

        LinkQuality read() {
            return new LinkQuality(roundTripMs, answers, misses, repeats, lastMissNanos);
        }
    }
}
