package majic.aibo;

/**
 * What the dog's clock shows now, as far as can be told from here. A word from the dog was said before it was heard, and
 * a question was answered after it was asked; so its clock stands between two bounds, and this takes their middle. It is
 * wrong by no more than half of the shortest round trip of late, however slowly the dog answers. Thread-safe.
 */
final class DogClock {
    /** Bounds are forgotten after one to two of these, for clocks drift. */
    private static final double KEPT_S = 10;

    /** A bound that contradicts the other one by more than this was garbled on its way, ms. */
    private static final double DOUBTFUL_MS = 500;

    private final Watch watch;
    private Bounds now = Bounds.NONE;
    private Bounds before = Bounds.NONE;
    private long renewedNanos;

    /** What the dog's clock is ahead of ours, ms: at least and at most. */
    private record Bounds(double leastMs, double mostMs) {
        static final Bounds NONE = new Bounds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

        Bounds and(double least, double most) {
            return new Bounds(Math.max(leastMs, least), Math.min(mostMs, most));
        }
    }

    DogClock(Watch watch) {
        this.watch = watch;
        this.renewedNanos = watch.time().nanos();
    }

    private double nowMs() {
        return watch.time().nanos() / 1e6;
    }

    /** Something with this time stamp has just come in. */
    synchronized void heard(long stampMs) {
        renew();
        double aheadMs = stampMs - nowMs();
        if (aheadMs < known().mostMs() + DOUBTFUL_MS) {
            now = now.and(aheadMs, Double.POSITIVE_INFINITY);
        }
    }

    /** The answer to a question that went out at a time of our clock carries this time stamp. */
    synchronized void answered(long stampMs, long askedNanos) {
        heard(stampMs);
        double aheadMs = stampMs - askedNanos / 1e6;
        if (aheadMs > known().leastMs() - DOUBTFUL_MS) {
            now = now.and(Double.NEGATIVE_INFINITY, aheadMs);
        }
    }

    private void renew() {
        if (watch.time().secondsSince(renewedNanos) > KEPT_S) {
            renewedNanos = watch.time().nanos();
            before = now;
            now = Bounds.NONE;
        }
    }

    private Bounds known() {
        return now.and(before.leastMs(), before.mostMs());
    }

    /** The time stamp that a word said now would carry; the newest it can be sure of before a question was answered. */
    synchronized double estimateMs() {
        Bounds known = known();
        double aheadMs = Double.isInfinite(known.mostMs()) ? known.leastMs() : (known.leastMs() + known.mostMs()) / 2;
        return nowMs() + aheadMs;
    }

    /** How long the dog takes to answer at best, seconds; 0 before it is known. */
    synchronized double roundTripS() {
        Bounds known = known();
        double roundTripMs = known.mostMs() - known.leastMs();
        return Double.isFinite(roundTripMs) ? Math.max(0, roundTripMs / 1000) : 0;
    }
}
