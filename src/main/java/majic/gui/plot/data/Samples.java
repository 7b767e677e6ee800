package majic.gui.plot.data;

import java.util.Arrays;

/** Holds the readings of one curve, the newest {@value #MOST}: almost two hours of ten a second. Thread-safe. */
public final class Samples implements CurvePoints {
    static final int MOST = 1 << 16;
    private static final int FIRST_ROOM = 256;

    private double[] times = new double[FIRST_ROOM];
    private double[] values = new double[FIRST_ROOM];
    private int first;
    private int count;

    /**
     * Adds a reading.
     *
     * @param seconds when it was taken, on the clock of the plot's source; a time before the last reading counts as its
     *     time
     * @param value the reading; NaN where there is none, which interrupts the curve
     */
    public synchronized void add(double seconds, double value) {
        double time = count == 0 ? seconds : Math.max(seconds, times[place(count - 1)]);
        if (count == times.length && count < MOST) {
            enlarge();
        }
        if (count == MOST) {
            first = (first + 1) % MOST;
            count--;
        }
        times[place(count)] = time;
        values[place(count)] = value;
        count++;
    }

    /**
     * Adds changes from before the first reading, the last of which holds until then; the oldest are left out if there
     * are too many.
     *
     * @param past changes, of which those from before the first reading are added
     */
    public synchronized void addPast(Points past) {
        Points present = copy(0, count);
        double start = start();
        first = 0;
        count = 0;
        for (int index = 0; index < past.size() && !(past.times()[index] >= start); index++) {
            add(past.times()[index], past.values()[index]);
        }
        if (count > 0 && present.size() > 0) {
            add(Math.nextDown(start), newest());
        }
        for (int index = 0; index < present.size(); index++) {
            add(present.times()[index], present.values()[index]);
        }
    }

    /** Adds readings from after the newest one; the oldest are left out if there are too many. */
    public synchronized void addLater(Points later) {
        double end = count == 0 ? Double.NEGATIVE_INFINITY : times[place(count - 1)];
        for (int index = 0; index < later.size(); index++) {
            if (later.times()[index] > end) {
                add(later.times()[index], later.values()[index]);
            }
        }
    }

    private void enlarge() {
        times = Arrays.copyOf(times, 2 * times.length);
        values = Arrays.copyOf(values, 2 * values.length);
    }

    private int place(int index) {
        return (first + index) % times.length;
    }

    /** Returns the newest reading; NaN if there is none. */
    synchronized double newest() {
        return count == 0 ? Double.NaN : values[place(count - 1)];
    }

    @Override
    public synchronized double at(double seconds) {
        int after = firstAfter(seconds);
        return after == 0 ? Double.NaN : values[place(after - 1)];
    }

    @Override
    public synchronized double start() {
        return count == 0 ? Double.NaN : times[first];
    }

    @Override
    public synchronized Points around(Span span) {
        int from = Math.max(0, firstAfter(span.from()) - 1);
        int to = Math.min(count, firstAfter(span.to()) + 1);
        return copy(from, Math.max(from, to));
    }

    @Override
    public synchronized Points within(Span span) {
        int from = firstAfter(Math.nextDown(span.from()));
        return copy(from, Math.max(from, firstAfter(span.to())));
    }

    private Points copy(int from, int to) {
        double[] x = new double[to - from];
        double[] y = new double[to - from];
        for (int index = from; index < to; index++) {
            x[index - from] = times[place(index)];
            y[index - from] = values[place(index)];
        }
        return new Points(x, y);
    }

    /** Returns the index of the first reading after a time. */
    private int firstAfter(double seconds) {
        int low = 0;
        int high = count;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (times[place(middle)] <= seconds) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
