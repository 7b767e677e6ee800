package majic.figures;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** The figures of {@link SharedLoad} as a table. */
final class SharedTable {
    private static final List<String> HEADS = List.of(
            "desks",
            "robots",
            "CPU desks %",
            "CPU broker %",
            "CPU robots %",
            "in B/s",
            "out B/s",
            "turn first",
            "written p50",
            "p99",
            "arrived p50",
            "p99",
            "bare p50",
            "p99",
            "lost",
            "drive first",
            "written p50",
            "p99",
            "arrived p50",
            "p99",
            "bare p50",
            "p99",
            "lost",
            "STOP p50",
            "p99",
            "all p50",
            "p99",
            "lost");
    private static final List<String> FORMATS = List.of(
            "%.0f",
            "%.0f", "%.1f", "%.1f", "%.1f", "%.0f", "%.0f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f",
            "%.0f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f", "%.2f", "%.0f", "%.1f", "%.1f", "%.1f", "%.1f",
            "%.0f");

    private SharedTable() {}

    static String head() {
        return line(HEADS);
    }

    static String row(String figures) {
        double[] values = Arrays.stream(figures.split(" "))
                .mapToDouble(Double::parseDouble)
                .toArray();
        return line(IntStream.range(0, values.length)
                .mapToObj(column -> String.format(Locale.ROOT, FORMATS.get(column), values[column]))
                .toList());
    }

    private static String line(List<String> cells) {
        return IntStream.range(0, cells.size())
                .mapToObj(column -> {
                    int width = Math.max(6, HEADS.get(column).length());
                    return String.format("%" + width + "s", cells.get(column));
                })
                .collect(Collectors.joining("  "));
    }
}
