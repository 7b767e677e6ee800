package majic.fuzzing;

import java.io.IOException;
import java.util.List;

/**
 * Runs the fuzz tests one after the other, each in a program of its own, and prints a row for each of them: executions,
 * executions a second, instrumented edges that were reached, inputs that reached new ones, largest memory, findings.
 * Arguments: minutes for each test, then words that select tests by their names; without words all are run. Ends with
 * exit code 1 if there are findings.
 */
public final class Fuzzing {
    private static final double SECONDS_PER_MINUTE = 60;

    private Fuzzing() {}

    /** Runs and prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        long seconds = Math.round(Double.parseDouble(arguments[0]) * SECONDS_PER_MINUTE);
        List<String> words = List.of(arguments).subList(1, arguments.length);
        List<FuzzTarget> targets = FuzzTarget.all().stream()
                .filter(target -> words.isEmpty() || words.stream().anyMatch(target.toString()::contains))
                .toList();
        if (targets.isEmpty()) {
            throw new IllegalArgumentException("no fuzz test has one of these words in its name: " + words);
        }
        int nameLength = targets.stream()
                .mapToInt(target -> target.toString().length())
                .max()
                .orElseThrow();
        System.out.println(FuzzResult.heading(nameLength));
        int findings = 0;
        for (FuzzTarget target : targets) {
            FuzzResult result = target.run(seconds);
            System.out.println(result.row(target, nameLength));
            result.findings().forEach(file -> System.out.println("    " + file));
            findings += result.findings().size();
        }
        System.exit(findings == 0 ? 0 : 1);
    }
}
