package majic.program;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;

/**
 * Whole programs, each a process with arguments, input, output and an exit status; closing ends them. A program that
 * has not ended after two minutes is ended, so that a test that reads what it never prints fails instead of waiting.
 */
final class MajicProcesses implements AutoCloseable {
    private static final int LIMIT_S = 120;
    private static final Executor LATER = CompletableFuture.delayedExecutor(LIMIT_S, TimeUnit.SECONDS);

    private final List<Process> started = new ArrayList<>();

    /**
     * Starts MAJIC; its errors are in its output.
     *
     * @param home its own folder
     * @param java options of the Java that runs it
     * @param arguments its own
     */
    Process start(Path home, List<String> java, List<String> arguments) throws IOException {
        return start(Map.of(), home, java, arguments);
    }

    /** Starts MAJIC as above, with these variables beside those of its environment. */
    Process start(Map<String, String> variables, Path home, List<String> java, List<String> arguments)
            throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(java);
        command.addAll(List.of(
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                "majic.Majic"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("MAJIC_HOME", home.toString());
        builder.environment().putAll(variables);
        Process process = builder.start();
        started.add(process);
        LATER.execute(process::destroyForcibly);
        return process;
    }

    /** Types lines and the end of the input, waits for the end of the program and returns all its output. */
    static String talk(Process process, String input) throws IOException, InterruptedException {
        try (OutputStream out = process.getOutputStream()) {
            out.write(input.getBytes(StandardCharsets.UTF_8));
        }
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }

    @Override
    public void close() {
        started.forEach(Process::destroyForcibly);
    }
}
