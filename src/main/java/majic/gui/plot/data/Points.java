package majic.gui.plot.data;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Readings in the order of time. Its arrays must not be changed.
 *
 * @param times seconds, not descending
 * @param values as many; NaN where there is no reading
 */
public record Points(double[] times, double[] values) {

    /** Returns the number of points. */
    public int size() {
        return times.length;
    }

    /**
     * Makes points of values of which only changes are known, so that a curve shows each until shortly before the next.
     *
     * @param times the times of the changes, seconds, not descending
     * @param values the values from then on; infinite ones become NaN
     * @param period the usual time between two readings, seconds
     */
    static Points ofChanges(double[] times, double[] values, double period) {
        double[] allTimes = new double[2 * times.length];
        double[] allValues = new double[2 * times.length];
        int count = 0;
        for (int index = 0; index < times.length; index++) {
            double value = Double.isFinite(values[index]) ? values[index] : Double.NaN;
            if (index > 0 && times[index] - times[index - 1] > 2 * period) {
                allTimes[count] = times[index] - period;
                allValues[count] = allValues[count - 1];
                count++;
            }
            allTimes[count] = times[index];
            allValues[count++] = value;
        }
        return new Points(Arrays.copyOf(allTimes, count), Arrays.copyOf(allValues, count));
    }

    /** Returns these points with the last value held until a time. */
    Points heldUntil(double seconds) {
        if (size() == 0 || times[size() - 1] >= seconds) {
            return this;
        }
        double[] longerTimes = Arrays.copyOf(times, size() + 1);
        double[] longerValues = Arrays.copyOf(values, size() + 1);
        longerTimes[size()] = seconds;
        longerValues[size()] = values[size() - 1];
        return new Points(longerTimes, longerValues);
    }

    /** Returns the same readings at other times. */
    Points moved(double seconds) {
        return new Points(Arrays.stream(times).map(time -> time + seconds).toArray(), values);
    }

    /**
     * Returns fewer points that look the same: for each column of pixels the first, lowest, highest and last one, and
     * one where the curve is interrupted.
     *
     * @param span the time that all columns together show
     * @param columns number of columns of pixels
     * @return at most five points a column; these points if there are no more of them than columns
     */
    public Points thinned(Span span, int columns) {
        if (size() <= columns) {
            return this;
        }
        Thinning thinning = new Thinning();
        int begin = 0;
        while (begin < size()) {
            long column = column(begin, span, columns);
            int end = begin + 1;
            while (end < size() && column(end, span, columns) == column) {
                end++;
            }
            thinning.keepOf(begin, end);
            begin = end;
        }
        return thinning.kept();
    }

    /**
     * Returns these points without those in the middle of a horizontal piece, which would be painted over each other.
     */
    public Points withoutRepeats() {
        int[] kept = IntStream.range(0, size())
                .filter(index -> index == 0
                        || index == size() - 1
                        || values[index] != values[index - 1]
                        || values[index] != values[index + 1])
                .toArray();
        return new Points(
                Arrays.stream(kept).mapToDouble(index -> times[index]).toArray(),
                Arrays.stream(kept).mapToDouble(index -> values[index]).toArray());
    }

    private long column(int index, Span span, int columns) {
        return (long) Math.floor((times[index] - span.from()) / span.length() * columns);
    }

    /** Collects the points that are kept. */
    private final class Thinning {
        private final double[] keptTimes = new double[size()];
        private final double[] keptValues = new double[size()];
        private int count;

        /** Keeps the characteristic points of one column, in their order. */
        void keepOf(int begin, int end) {
            int lowest = begin;
            int highest = begin;
            int gap = -1;
            for (int index = begin; index < end; index++) {
                double value = values[index];
                if (Double.isNaN(value)) {
                    gap = index;
                } else {
                    lowest = !(values[lowest] <= value) ? index : lowest;
                    highest = !(values[highest] >= value) ? index : highest;
                }
            }
            int[] chosen = {begin, lowest, highest, gap < 0 ? begin : gap, end - 1};
            Arrays.sort(chosen);
            int before = -1;
            for (int index : chosen) {
                if (index != before) {
                    keptTimes[count] = times[index];
                    keptValues[count++] = values[index];
                    before = index;
                }
            }
        }

        Points kept() {
            return new Points(Arrays.copyOf(keptTimes, count), Arrays.copyOf(keptValues, count));
        }
    }
}
