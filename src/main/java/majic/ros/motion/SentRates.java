package majic.ros.motion;

import java.util.ArrayDeque;
import java.util.Deque;

/** The rates that were commanded in the last moments, each until the next one. Has no clock. Not thread-safe. */
final class SentRates {
    /** Longer than any delay that is learned, seconds. */
    private static final double KEPT_S = 2;

    private final Deque<Sent> sent = new ArrayDeque<>();

    private record Sent(double rate, double seconds) {}

    void add(double rate, double seconds) {
        sent.add(new Sent(rate, seconds));
        while (sent.size() > 1 && sent.peek().seconds < seconds - KEPT_S) {
            sent.remove();
        }
    }

    /** The newest rate; zero before the first. */
    double newest() {
        return sent.isEmpty() ? 0 : sent.getLast().rate;
    }

    /** What a base covers between two times if it follows the rates at once. */
    double covered(double from, double to) {
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

    /** When a magnitude was first reached; NaN if it was not. */
    double reachedAt(double magnitude) {
        for (Sent one : sent) {
            if (Math.abs(one.rate) >= magnitude) {
                return one.seconds;
            }
        }
        return Double.NaN;
    }

    /** The largest magnitude. */
    double highest() {
        return sent.stream().mapToDouble(one -> Math.abs(one.rate)).max().orElse(0);
    }
}
