package majic.figures;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The figures of {@link TeamLoad} for teams of growing size. The program itself takes some memory however few robots it
 * has, so that of a robot is the difference from the smaller team before, divided by the number of further robots;
 * {@link FurtherRobots} does the same for the processor time.
 */
final class LoadTable {
    private static final String[] HEADS = {
        "robots",
        "CPU %",
        "heap KB",
        "threads",
        "p50 ms",
        "p99 ms",
        "p99.9 ms",
        "commands/s",
        "us CPU each",
        "not sent",
        "GCs",
        "longest ms",
        "KB a further"
    };
    private static final String[] FORMATS = {
        "%.0f", "%.2f", "%.0f", "%.0f", "%.3f", "%.3f", "%.3f", "%.0f", "%.0f", "%.0f", "%.0f", "%.0f", "%.1f"
    };
    private static final int ROBOTS = 0;
    private static final int HEAP_KB = 2;
    private static final int MEASURED = HEADS.length - 1;

    private double[] before = new double[MEASURED];

    static String head() {
        return line(HEADS);
    }

    /** Adds a larger team than the last one. */
    String row(String figures) {
        double[] row = Arrays.copyOf(values(figures), HEADS.length);
        double further = row[ROBOTS] - before[ROBOTS];
        row[MEASURED] = (row[HEAP_KB] - before[HEAP_KB]) / further;
        before = row;
        return formatted(row);
    }

    /** Formats a team that is not compared with another. */
    static String single(String figures) {
        return formatted(values(figures));
    }

    private static double[] values(String figures) {
        return Arrays.stream(figures.split(" "))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    private static String formatted(double[] values) {
        return line(IntStream.range(0, values.length)
                .mapToObj(column -> String.format(Locale.ROOT, FORMATS[column], values[column]))
                .toArray(String[]::new));
    }

    private static String line(String[] cells) {
        return Arrays.stream(cells).map(cell -> String.format("%12s", cell)).collect(Collectors.joining(" "));
    }
}
