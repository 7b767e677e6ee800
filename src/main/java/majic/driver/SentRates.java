package majic.driver;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * The rates that were commanded in the last moments, mm/s or deg/s, signed, each until the next one. Has no clock. Not
 * thread-safe.
 */
public final class SentRates {
    /** Longer than any delay that is learned, seconds. */
    private static final double KEPT_S = 2;

    private final Deque<Sent> sent = new ArrayDeque<>();

    private record Sent(double rate, double seconds) {}

    /**
     * Adds a rate.
     *
     * @param rate commanded now
     * @param seconds now, not before the last one
     */
    public void add(double rate, double seconds) {
        sent.add(new Sent(rate, seconds));
        while (sent.size() > 1 && sent.peek().seconds < seconds - KEPT_S) {
            sent.remove();
        }
    }

    /** Returns when the oldest one that is kept was commanded, seconds; NaN before the first. */
    public double firstS() {
        return sent.isEmpty() ? Double.NaN : sent.getFirst().seconds;
    }

    /**
     * Returns the rate that was in force at a time.
     *
     * @param seconds the time
     * @param before the rate before the first one that is kept
     * @return the last one commanded until then
     */
    public double at(double seconds, double before) {
        for (var all = sent.descendingIterator(); all.hasNext(); ) {
            Sent one = all.next();
            if (one.seconds <= seconds) {
                return one.rate;
            }
        }
        return before;
    }

    /** Returns the newest rate; zero before the first. */
    public double newest() {
        return sent.isEmpty() ? 0 : sent.getLast().rate;
    }

    /** Returns what a robot covers between two times, seconds, if it follows the rates at once: mm or degrees. */
    public double covered(double from, double to) {
        double sum = 0;
        double end = to;
        for (var all = sent.descendingIterator(); all.hasNext() && end > from; ) {
            Sent one = all.next();
            double begin = Math.max(from, one.seconds);
            sum += Math.max(0, end - begin) * one.rate;
            end = Math.min(end, begin);
        }
        return sum;
    }

    /** Returns when a magnitude was first reached, seconds; NaN if it was not. */
    public double reachedAt(double magnitude) {
        for (Sent one : sent) {
            if (Math.abs(one.rate) >= magnitude) {
                return one.seconds;
            }
        }
        return Double.NaN;
    }

    /** Returns the largest magnitude; zero before the first. */
    public double highest() {
        return sent.stream().mapToDouble(one -> Math.abs(one.rate)).max().orElse(0);
    }
}
