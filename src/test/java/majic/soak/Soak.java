package majic.soak;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Collectors;

/**
 * Sends commands to teams in labs whose connections fail, round by round, until there are as many as were asked for,
 * and prints how they ended. The arguments are {@code commands=1000000} and {@code seed=1}, the seed of the first
 * round; each further round has the next one. Ends with status 1 after the first round that finds a problem.
 */
public final class Soak {
    private static final int LINES_OF_A_ROUND = 6000;
    private static final int MOST_PRINTED = 40;

    private final Map<Outcome, Long> outcomes = new EnumMap<>(Outcome.class);
    private final Map<FaultScript.Kind, Long> faults = new EnumMap<>(FaultScript.Kind.class);
    private final AtomicLong progress = new AtomicLong();
    private final long beganNanos = System.nanoTime();
    private double labSeconds;

    private Soak() {}

    /** Runs it. */
    @SuppressWarnings("try")
    public static void main(String[] arguments) throws IOException, InterruptedException {
        long commands = 1_000_000;
        long seed = 1;
        for (String argument : arguments) {
            String[] parts = argument.split("=", 2);
            switch (parts[0]) {
                case "commands" -> commands = Long.parseLong(parts[1]);
                case "seed" -> seed = Long.parseLong(parts[1]);
                default -> throw new IllegalArgumentException(argument + ": there are commands=N and seed=N");
            }
        }
        Logger.getLogger("").setLevel(Level.WARNING);
        Soak soak = new Soak();
        try (ProgressWatch watch = new ProgressWatch(soak.progress::get, Soak::giveUp)) {
            soak.run(commands, seed);
        }
    }

    private void run(long commands, long firstSeed) throws IOException, InterruptedException {
        Resources atFirst = Resources.now();
        round(firstSeed);
        Resources before = Resources.settledSince(atFirst);
        for (long seed = firstSeed + 1; sum(outcomes) < commands; seed++) {
            round(seed);
        }
        Resources after = Resources.settledSince(before);
        say("%d commands in %.0f s, %.1f h of the lab", sum(outcomes), seconds(), labSeconds / 3600);
        say("outcomes: %s", table(outcomes));
        say("faults: %s", table(faults));
        say("after the first round: %s", before);
        say("after the last round: %s", after);
        if (!after.leftOverSince(before).isEmpty()) {
            giveUp("left over: " + after.leftOverSince(before));
        }
    }

    private void round(long seed) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("majic-soak");
        SoakRound.Result result = new SoakRound(seed, LINES_OF_A_ROUND, progress).run(folder);
        result.outcomes().forEach((how, count) -> outcomes.merge(how, count, Long::sum));
        result.faults().forEach((kind, count) -> faults.merge(kind, count, Long::sum));
        labSeconds += result.labSeconds();
        say("seed %d: %d commands in all after %.0f s; %s", seed, sum(outcomes), seconds(), table(outcomes));
        if (!result.problems().isEmpty()) {
            giveUp(String.format(
                    Locale.ROOT,
                    "%d problems with seed=%d; the files are in %s%n%s",
                    result.problems().size(),
                    seed,
                    folder,
                    result.problems().stream()
                            .limit(MOST_PRINTED)
                            .collect(Collectors.joining(System.lineSeparator()))));
        }
        for (Path file : List.of(result.log(), folder.resolve(SoakLab.ACT_FILE), folder)) {
            Files.delete(file);
        }
    }

    private double seconds() {
        return (System.nanoTime() - beganNanos) / 1e9;
    }

    private static long sum(Map<?, Long> counts) {
        return counts.values().stream().mapToLong(Long::longValue).sum();
    }

    private static String table(Map<?, Long> counts) {
        return counts.entrySet().stream()
                .map(count ->
                        count.getKey().toString().toLowerCase(Locale.ROOT).replace('_', ' ') + " " + count.getValue())
                .collect(Collectors.joining(", "));
    }

    private static void giveUp(String why) {
        say("%s", why);
        System.exit(1);
    }

    private static void say(String format, Object... values) {
        System.out.println(String.format(Locale.ROOT, format, values));
    }
}
