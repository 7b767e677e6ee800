package majic.fuzzing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * What a search found.
 *
 * @param executions how often the test ran
 * @param perSecond how often a second, while it searched
 * @param coverage edges of instrumented code that were reached
 * @param newInputs inputs that reached new edges, or known ones in another number of rounds
 * @param megabytes the largest memory of the process
 * @param findings the files with the input that made the test fail, or take too much time or memory
 */
record FuzzResult(
        long executions, long perSecond, long coverage, long newInputs, long megabytes, List<String> findings) {
    private static final String ROW = "%12s %8s %9s %11s %5s %9s";
    private static final Pattern COVERAGE = Pattern.compile("cov: (\\d+)");
    private static final Pattern FINDING = Pattern.compile("Test unit written to (.*)");

    /** Reads what libFuzzer has printed. */
    static FuzzResult of(Path output) throws IOException {
        String text = Files.readString(output, StandardCharsets.ISO_8859_1);
        if (!text.contains("stat::")) {
            throw new IOException("the search did not run to its end; see " + output);
        }
        return new FuzzResult(
                statistic("number_of_executed_units", text),
                statistic("average_exec_per_sec", text),
                last(COVERAGE, text),
                statistic("new_units_added", text),
                statistic("peak_rss_mb", text),
                FINDING.matcher(text).results().map(found -> found.group(1)).toList());
    }

    /** Returns this result and that of the search that was continued afterwards, whose findings count. */
    FuzzResult then(FuzzResult next) {
        double seconds =
                executions / (double) Math.max(1, perSecond) + next.executions / (double) Math.max(1, next.perSecond);
        long all = executions + next.executions;
        return new FuzzResult(
                all,
                Math.round(all / Math.max(1, seconds)),
                Math.max(coverage, next.coverage),
                newInputs + next.newInputs,
                Math.max(megabytes, next.megabytes),
                next.findings);
    }

    private static long statistic(String name, String text) {
        return last(Pattern.compile("stat::" + name + ":\\s*(\\d+)"), text);
    }

    private static long last(Pattern pattern, String text) {
        return pattern.matcher(text)
                .results()
                .map(found -> Long.parseLong(found.group(1)))
                .reduce((before, last) -> last)
                .orElse(0L);
    }

    static String heading(int nameLength) {
        return row(nameLength, "fuzz test", "executions", "/s", "coverage", "new inputs", "MB", "findings");
    }

    /** Returns a row of the table. */
    String row(FuzzTarget target, int nameLength) {
        return row(nameLength, target, executions, perSecond, coverage, newInputs, megabytes, findings.size());
    }

    private static String row(int nameLength, Object... columns) {
        return String.format(Locale.ROOT, "%-" + nameLength + "s" + ROW, columns);
    }
}
