package majic.recorder;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The recorded values of one thing, as texts over time. Numbers take 12 bytes each. Filled by one thread, then read by
 * any.
 */
final class Track {
    private static final int FIRST_CAPACITY = 4;

    /** Over three weeks. */
    private static final int LONGEST_MS = 2_000_000_000;

    private int[] atMs = new int[FIRST_CAPACITY];
    private double[] numbers = new double[FIRST_CAPACITY];
    private final Map<Integer, String> texts = new HashMap<>();

    /** Numbers with more digits than usual, as those of a latitude. */
    private final BitSet plain = new BitSet();

    private int size;

    /** Adds a value at a time that is not before the last one. */
    void add(double seconds, String text) {
        double exact = ValueText.exact(text);
        if (Double.isNaN(exact)) {
            double amount = ValueText.amount(text);
            if (Double.isFinite(amount) && ValueText.plain(amount).equals(text)) {
                plain.set(size);
            } else {
                texts.put(size, text);
            }
            add(seconds, amount);
        } else {
            add(seconds, exact);
        }
    }

    /** Adds a number. */
    void add(double seconds, double number) {
        if (size == atMs.length) {
            atMs = Arrays.copyOf(atMs, 2 * size);
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        atMs[size] = ms(seconds);
        numbers[size] = number;
        size++;
    }

    private static int ms(double seconds) {
        return (int) Math.max(-LONGEST_MS, Math.min(LONGEST_MS, seconds * 1000 + Math.signum(seconds) * 0.5));
    }

    int size() {
        return size;
    }

    double seconds(int index) {
        return atMs[index] / 1000.0;
    }

    String text(int index) {
        String text = texts.get(index);
        if (text != null) {
            return text;
        }
        return plain.get(index) ? ValueText.plain(numbers[index]) : ValueText.of(numbers[index]);
    }

    /** The value in force at a time; null before the first. */
    @Nullable
    String at(double seconds) {
        int index = indexAt(seconds);
        return index < 0 ? null : text(index);
    }

    /** The number in force at a time; NaN before the first, and for what is no number. */
    double numberAt(double seconds) {
        int index = indexAt(seconds);
        return index < 0 ? Double.NaN : numbers[index];
    }

    /** The last number until a time; NaN if there was none. */
    double lastNumberAt(double seconds) {
        int index = indexAt(seconds);
        while (index >= 0 && !Double.isFinite(numbers[index])) {
            index--;
        }
        return index < 0 ? Double.NaN : numbers[index];
    }

    /** The index of the value in force at a time; -1 before the first. */
    int indexAt(double seconds) {
        int found = Arrays.binarySearch(atMs, 0, size, ms(seconds) + 1);
        int after = found < 0 ? -found - 1 : found;
        while (after > 0 && atMs[after - 1] > ms(seconds)) {
            after--;
        }
        return after - 1;
    }

    /** The times of the changes after a time, up to another one. */
    double[] times(double afterS, double toS) {
        int first = indexAt(afterS) + 1;
        double[] times = new double[Math.max(0, indexAt(toS) + 1 - first)];
        for (int index = 0; index < times.length; index++) {
            times[index] = seconds(first + index);
        }
        return times;
    }

    /** The numbers from a time on, beginning with the one in force then. */
    Series series(double fromS) {
        int first = Math.max(0, indexAt(fromS));
        return new Series(times(first), Arrays.copyOfRange(numbers, first, size));
    }

    /** The numbers in one item of lists, from a time on. */
    Series series(double fromS, int item) {
        int first = Math.max(0, indexAt(fromS));
        double[] values = new double[size - first];
        Arrays.setAll(values, index -> ValueText.amount(text(first + index), item));
        return new Series(times(first), values);
    }

    private double[] times(int first) {
        double[] times = new double[size - first];
        Arrays.setAll(times, index -> seconds(first + index));
        return times;
    }
}
