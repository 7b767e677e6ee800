package majic.aibo.urbi;

import majic.time.TimeSource;

/**
 * Estimates what the dog's clock shows now. A message was sent before it was received, and an answer was sent after its
 * question; so the offset of the dog's clock lies between two bounds, and the estimate is the middle. Its error is at
 * most half of the shortest recent round trip, however slowly the dog answers. Thread-safe.
 */
public final class DogClock {
    /** Bounds are discarded after one to two of these, because clocks drift. */
    private static final double KEPT_S = 10;

    /** A bound that contradicts the other one by more than this comes from a damaged time stamp, ms. */
    private static final double DOUBTFUL_MS = 500;

    /** If so many in a row contradict a bound, the bound comes from a damaged time stamp. */
    private static final int ENOUGH_AGAINST_IT = 3;

    private final TimeSource time;
    private Bounds now = Bounds.NONE;
    private Bounds before = Bounds.NONE;
    private long renewedNanos;
    private int messagesAgainst;
    private int answersAgainst;

    /** By how much the dog's clock is ahead of this computer's, ms: at least and at most. */
    private record Bounds(double leastMs, double mostMs) {
        static final Bounds NONE = new Bounds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

        Bounds and(double least, double most) {
            return new Bounds(Math.max(leastMs, least), Math.min(mostMs, most));
        }
    }

    public DogClock(TimeSource time) {
        this.time = time;
        this.renewedNanos = time.nanos();
    }

    private double nowMs() {
        return time.nanos() / 1e6;
    }

    /** Records that a message with this time stamp was received now. */
    public synchronized void received(long stampMs) {
        renew();
        double aheadMs = stampMs - nowMs();
        boolean fits = aheadMs < known().mostMs + DOUBTFUL_MS;
        messagesAgainst = fits ? 0 : messagesAgainst + 1;
        if (fits || startsOver(messagesAgainst)) {
            now = now.and(aheadMs, Double.POSITIVE_INFINITY);
        }
    }

    /** Records the time stamp of the answer to a question that was sent at a time of this computer's clock. */
    public synchronized void answered(long stampMs, long askedNanos) {
        received(stampMs);
        double aheadMs = stampMs - askedNanos / 1e6;
        boolean fits = aheadMs > known().leastMs - DOUBTFUL_MS;
        answersAgainst = fits ? 0 : answersAgainst + 1;
        if (fits) {
            now = now.and(Double.NEGATIVE_INFINITY, aheadMs);
        } else if (startsOver(answersAgainst)) {
            now = now.and(stampMs - nowMs(), aheadMs);
        }
    }

    /** Discards the bounds if enough messages contradict them. */
    private boolean startsOver(int against) {
        if (against < ENOUGH_AGAINST_IT) {
            return false;
        }
        now = Bounds.NONE;
        before = Bounds.NONE;
        messagesAgainst = 0;
        answersAgainst = 0;
        return true;
    }

    private void renew() {
        if (time.secondsSince(renewedNanos) > KEPT_S) {
            renewedNanos = time.nanos();
            before = now;
            now = Bounds.NONE;
        }
    }

    private Bounds known() {
        return now.and(before.leastMs, before.mostMs);
    }

    /**
     * Returns the time stamp that a message sent now would carry; before the first answer, the newest that is certain.
     */
    public synchronized double estimateMs() {
        Bounds known = known();
        double aheadMs = Double.isInfinite(known.mostMs) ? known.leastMs : (known.leastMs + known.mostMs) / 2;
        return nowMs() + aheadMs;
    }

    /** Returns when the dog's clock showed a time stamp, on this computer's clock; not later than now, ns. */
    public synchronized long nanosAt(long stampMs) {
        double ageMs = Math.max(0, estimateMs() - stampMs);
        return time.nanos() - (long) (ageMs * 1e6);
    }

    /** How long the dog takes to answer at best, seconds; 0 before it is known. */
    public synchronized double roundTripS() {
        Bounds known = known();
        double roundTripMs = known.mostMs - known.leastMs;
        return Double.isFinite(roundTripMs) ? Math.max(0, roundTripMs / 1000) : 0;
    }
}
