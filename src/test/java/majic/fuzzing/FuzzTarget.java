package majic.fuzzing;

import com.code_intelligence.jazzer.Jazzer;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.lang.reflect.Method;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * One fuzz test.
 *
 * @param className the class
 * @param method the method
 */
record FuzzTarget(String className, String method) {
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();
    private static final String ENDING = "FuzzTest.class";

    /** No input of a few kilobytes may take more, bytes. */
    private static final String LARGEST_HEAP = "-Xmx512m";

    /** No input of a few kilobytes may take longer, seconds of processor time. */
    private static final int LONGEST_RUN_S = 30;

    private static final int NEVER_S = 1_000_000;

    private static final int LONGEST_START_S = 300;

    /** Returns all fuzz tests, sorted by name. */
    static List<FuzzTarget> all() throws IOException {
        Path classes = testClasses();
        try (Stream<Path> files = Files.walk(classes)) {
            return files.map(file -> classes.relativize(file).toString().replace('\\', '/'))
                    .filter(path -> path.endsWith(ENDING))
                    .sorted()
                    .map(path -> path.replaceFirst("\\.class$", "").replace('/', '.'))
                    .flatMap(FuzzTarget::in)
                    .toList();
        }
    }

    private static Path testClasses() {
        try {
            return Path.of(FuzzTarget.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Stream<FuzzTarget> in(String className) {
        try {
            return Stream.of(Class.forName(className).getDeclaredMethods())
                    .filter(method -> method.isAnnotationPresent(FuzzTest.class))
                    .map(Method::getName)
                    .sorted()
                    .map(method -> new FuzzTarget(className, method));
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Searches for new inputs, starting from the kept ones and from those of earlier runs ({@code .cifuzz-corpus}), and
     * ends at the first finding. Blocks. An input that was slow only because the computer was busy, or the search was
     * suspended, is deleted, and the search continues.
     *
     * @param seconds how long to search
     * @return what the search found; its whole output is in {@code target/fuzz}
     */
    FuzzResult run(long seconds) throws IOException, InterruptedException {
        long endNanos = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        FuzzResult result = search(seconds);
        while (isDismissed(result)) {
            long left = TimeUnit.NANOSECONDS.toSeconds(endNanos - System.nanoTime());
            result = result.then(search(Math.max(1, left)));
        }
        return result;
    }

    private FuzzResult search(long seconds) throws IOException, InterruptedException {
        Process process = jazzer(
                log(".log"),
                "-max_total_time=" + seconds,
                "-timeout=" + LONGEST_RUN_S,
                "-report_slow_units=" + NEVER_S,
                "-print_final_stats=1");
        try {
            if (!process.waitFor(seconds + LONGEST_RUN_S + LONGEST_START_S, TimeUnit.SECONDS)) {
                throw new IOException(this + " does not end; see " + log(".log"));
            }
        } finally {
            process.destroyForcibly();
        }
        return FuzzResult.of(log(".log"));
    }

    /** Tests each slow input of a search alone; deletes it and returns true if none of the findings remains. */
    private boolean isDismissed(FuzzResult result) throws IOException, InterruptedException {
        for (Path input : result.findings().stream().map(Path::of).toList()) {
            if (!input.getFileName().toString().startsWith("timeout-") || isBad(input)) {
                return false;
            }
        }
        for (String input : result.findings()) {
            Files.delete(Path.of(input));
        }
        return !result.findings().isEmpty();
    }

    /**
     * Tests one input in a program of its own. Waiting for a processor does not count, waiting for ever does.
     *
     * @return whether it fails or is slow
     */
    private boolean isBad(Path input) throws IOException, InterruptedException {
        Process process = jazzer(log(".slow.log"), "-timeout=" + NEVER_S, input.toString());
        try {
            for (int second = 0; second < LONGEST_START_S; second++) {
                if (process.waitFor(1, TimeUnit.SECONDS)) {
                    return process.exitValue() != 0;
                }
                Duration used = process.info().totalCpuDuration().orElse(Duration.ZERO);
                if (used.toSeconds() >= LONGEST_RUN_S) {
                    return true;
                }
            }
            return true;
        } finally {
            process.destroyForcibly();
        }
    }

    private Path log(String ending) throws IOException {
        return Files.createDirectories(testClasses().resolveSibling("fuzz")).resolve(className + "." + method + ending);
    }

    private Process jazzer(Path output, String... options) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                JAVA,
                LARGEST_HEAP,
                "-XX:+UseSerialGC",
                "-XX:+EnableDynamicAgentLoading",
                "-Djava.util.logging.manager=majic.program.LogFile$OpenUntilTheEnd",
                "-cp",
                System.getProperty("java.class.path"),
                Jazzer.class.getName(),
                "--target_class=" + className,
                "--target_method=" + method,
                "--instrumentation_includes=majic.**:majicsim.**"));
        command.addAll(List.of(options));
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
    }

    @Override
    public String toString() {
        return className + "#" + method;
    }
}
