package majic.tool;

import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Runs programs of this computer that some tests need, such as a compiler of another language. */
public final class Tool {
    private Tool() {}

    /**
     * Skips the test if this computer does not have a program. The build of the project itself, which sets the variable
     * {@code CI}, must have it.
     */
    public static void require(String program) throws InterruptedException {
        try {
            run(program, "--version");
        } catch (IOException e) {
            if (System.getenv("CI") != null) {
                throw new AssertionError(program + " is missing", e);
            }
            abort("this computer has no " + program);
        }
    }

    /** Runs a command and returns what it prints, errors included. */
    public static String run(String... command) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder(List.of(command)).redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return printed;
    }
}
