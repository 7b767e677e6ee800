package majic.gui.bots;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.OptionalDouble;

/**
 * Judges a connection by the times of the robot's reports: how long the present one is overdue, and how regularly the
 * last ones came. Times are nanoseconds on the robot's clock. Must be used on one thread.
 */
final class LinkMeter {
    static final int MOST_BARS = 3;

    private static final double NANOS_PER_S = 1e9;
    private static final int REMEMBERED = 20;

    /** No interval below this counts as late, since the event thread itself may delay a report. */
    private static final double TOLERATED_S = 0.7;

    private static final double LATE = 3;
    private static final double VERY_LATE = 8;

    private final Deque<Double> intervals = new ArrayDeque<>();
    private long lastNanos;

    /** Notes the newest report; has no effect if it is known already. */
    void reported(long atNanos) {
        if (lastNanos != 0 && atNanos > lastNanos) {
            intervals.add((atNanos - lastNanos) / NANOS_PER_S);
            if (intervals.size() > REMEMBERED) {
                intervals.remove();
            }
        }
        lastNanos = Math.max(lastNanos, atNanos);
    }

    /** Forgets everything, after the connection was opened again. */
    void clear() {
        intervals.clear();
        lastNanos = 0;
    }

    /** Returns the age of the last report in s, if it is older than normal; empty if not, or before the first one. */
    OptionalDouble overdueS(long nowNanos) {
        double age = ageS(nowNanos);
        return age > lateS() ? OptionalDouble.of(age) : OptionalDouble.empty();
    }

    /** Returns the quality of the connection: 3 for regular reports, 0 for none at present. */
    int bars(long nowNanos) {
        double age = ageS(nowNanos);
        double longest =
                intervals.stream().mapToDouble(Double::doubleValue).max().orElse(0);
        double worst = Math.max(age, longest) / lateS();
        if (age > lateS() * VERY_LATE / LATE) {
            return 0;
        }
        return worst <= 1 ? MOST_BARS : worst <= VERY_LATE / LATE ? 2 : 1;
    }

    private double ageS(long nowNanos) {
        return lastNanos == 0 ? 0 : (nowNanos - lastNanos) / NANOS_PER_S;
    }

    /** Returns the interval from which on a report is late: three times the median. */
    private double lateS() {
        double[] sorted =
                intervals.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        double median = sorted.length == 0 ? 0 : sorted[sorted.length / 2];
        return Math.max(TOLERATED_S, LATE * median);
    }
}
