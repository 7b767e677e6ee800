package majic.aibo.urbi;

/**
 * What the dog's clock shows now, as far as can be told from here. A word from the dog was said before it was heard, and
 * a question was answered after it was asked; so its clock stands between two bounds, and this takes their middle. It is
 * wrong by no more than half of the shortest round trip of late, however slowly the dog answers. Thread-safe.
 */
public final class DogClock {
    /** Bounds are forgotten after one to two of these, for clocks drift. */
    private static final double KEPT_S = 10;

    /** A bound that contradicts the other one by more than this was garbled on its way, ms. */
    private static final double DOUBTFUL_MS = 500;

    /** Where so many in a row contradict a bound, it was the bound that was garbled. */
    private static final int ENOUGH_AGAINST_IT = 3;

    private final Waiting waiting;
    private Bounds now = Bounds.NONE;
    private Bounds before = Bounds.NONE;
    private long renewedNanos;
    private int wordsAgainst;
    private int answersAgainst;

    /** What the dog's clock is ahead of ours, ms: at least and at most. */
    private record Bounds(double leastMs, double mostMs) {
        static final Bounds NONE = new Bounds(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

        Bounds and(double least, double most) {
            return new Bounds(Math.max(leastMs, least), Math.min(mostMs, most));
        }
    }

    public DogClock(Waiting waiting) {
        this.waiting = waiting;
        this.renewedNanos = waiting.time().nanos();
    }

    private double nowMs() {
        return waiting.time().nanos() / 1e6;
    }

    /** Something with this time stamp has just come in. */
    public synchronized void heard(long stampMs) {
        renew();
        double aheadMs = stampMs - nowMs();
        boolean fits = aheadMs < known().mostMs() + DOUBTFUL_MS;
        wordsAgainst = fits ? 0 : wordsAgainst + 1;
        if (fits || startsOver(wordsAgainst)) {
            now = now.and(aheadMs, Double.POSITIVE_INFINITY);
        }
    }

    /** The answer to a question that went out at a time of our clock carries this time stamp. */
    public synchronized void answered(long stampMs, long askedNanos) {
        heard(stampMs);
        double aheadMs = stampMs - askedNanos / 1e6;
        boolean fits = aheadMs > known().leastMs() - DOUBTFUL_MS;
        answersAgainst = fits ? 0 : answersAgainst + 1;
        if (fits) {
            now = now.and(Double.NEGATIVE_INFINITY, aheadMs);
        } else if (startsOver(answersAgainst)) {
            now = now.and(stampMs - nowMs(), aheadMs);
        }
    }

    /** Forgets the bounds if enough messages contradict them. */
    private boolean startsOver(int against) {
        if (against < ENOUGH_AGAINST_IT) {
            return false;
        }
        now = Bounds.NONE;
        before = Bounds.NONE;
        wordsAgainst = 0;
        answersAgainst = 0;
        return true;
    }

    private void renew() {
        if (waiting.time().secondsSince(renewedNanos) > KEPT_S) {
            renewedNanos = waiting.time().nanos();
            before = now;
            now = Bounds.NONE;
        }
    }

    private Bounds known() {
        return now.and(before.leastMs(), before.mostMs());
    }

    /** Returns the time stamp that a message sent now would carry; before the first answer, the newest that is certain. */
    public synchronized double estimateMs() {
        Bounds known = known();
        double aheadMs = Double.isInfinite(known.mostMs()) ? known.leastMs() : (known.leastMs() + known.mostMs()) / 2;
        return nowMs() + aheadMs;
    }

    /** How long the dog takes to answer at best, seconds; 0 before it is known. */
    public synchronized double roundTripS() {
        Bounds known = known();
        double roundTripMs = known.mostMs() - known.leastMs();
        return Double.isFinite(roundTripMs) ? Math.max(0, roundTripMs / 1000) : 0;
    }
}
