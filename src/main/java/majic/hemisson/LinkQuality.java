package majic.hemisson;

/**
 * How well the line works. Immutable.
 *
 * @param roundTripMs mean time from a question to its answer, ms; 0 before the first
 * @param answers how many questions were answered
 * @param misses how many were not, or not in time
 */
record LinkQuality(double roundTripMs, long answers, long misses) {
    static final LinkQuality NONE = new LinkQuality(0, 0, 0);

    /** Counts; guarded by its owner. */
    static final class Meter {
        private static final double WEIGHT_OF_NEWEST = 0.1;

        private double roundTripMs;
        private long answers;
        private long misses;

        void answered(long roundTripNanos) {
            double newestMs = roundTripNanos / 1e6;
            roundTripMs += answers == 0 ? newestMs : WEIGHT_OF_NEWEST * (newestMs - roundTripMs);
            answers++;
        }

        void missed() {
            misses++;
        }

        LinkQuality read() {
            return new LinkQuality(roundTripMs, answers, misses);
        }
    }
}
