package majic.fuzzing;

import com.code_intelligence.jazzer.Jazzer;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.lang.reflect.Method;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
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

    /** No input of a few kilobytes may take longer. */
    private static final int LONGEST_RUN_S = 30;

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
     * ends at the first finding. Blocks.
     *
     * @param seconds how long to search
     * @return what the search found; its whole output is in {@code target/fuzz}
     */
    FuzzResult run(long seconds) throws IOException, InterruptedException {
        Path output = Files.createDirectories(testClasses().resolveSibling("fuzz"))
                .resolve(className + "." + method + ".log");
        Process process = new ProcessBuilder(
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
                        "--instrumentation_includes=majic.**:majicsim.**",
                        "-max_total_time=" + seconds,
                        "-timeout=" + LONGEST_RUN_S,
                        "-report_slow_units=" + LONGEST_RUN_S,
                        "-print_final_stats=1")
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
        try {
            if (!process.waitFor(seconds + LONGEST_RUN_S + LONGEST_START_S, TimeUnit.SECONDS)) {
                throw new IOException(this + " does not end; see " + output);
            }
        } finally {
            process.destroyForcibly();
        }
        return FuzzResult.of(output);
    }

    @Override
    public String toString() {
        return className + "#" + method;
    }
}
