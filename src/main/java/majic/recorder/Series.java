package majic.recorder;

import java.util.Arrays;
import java.util.List;

/**
 * The values of one parameter over time. Only changes are recorded: a value holds until the time of the next one.
 *
 * @param seconds the times, ascending, since the beginning of the recording; not to be changed
 * @param values one for each time, in the parameter's unit: 1 and 0 for yes and no or on and off, infinity for clear,
 *     NaN where there was no number; not to be changed
 */
public record Series(double[] seconds, double[] values) {
    /** Nothing was recorded. */
    public static final Series EMPTY = new Series(new double[0], new double[0]);

    /** One series behind the other. */
    static Series join(List<Series> parts) {
        return new Series(
                parts.stream()
                        .flatMapToDouble(part -> Arrays.stream(part.seconds))
                        .toArray(),
                parts.stream()
                        .flatMapToDouble(part -> Arrays.stream(part.values))
                        .toArray());
    }

    /**
     * Returns the number of values.
     *
     * @return 0 or more
     */
    public int size() {
        return seconds.length;
    }
}
