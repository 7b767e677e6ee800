package majic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.console.Console;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;

/** {@code majic run FILE}: runs a file of MAJIC Script, without a window. */
@Command(
        name = "run",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description = "Runs a file of MAJIC Script and ends; exit status 0 only if every line succeeded.")
public final class RunCommand implements Callable<Integer> {
    private final UserFolder folder;

    @ParentCommand
    private @Nullable MajicCommand majic;

    @Parameters(paramLabel = "FILE", description = "the script")
    private Path file = Path.of("");

    public RunCommand(UserFolder folder) {
        this.folder = folder;
    }

    @Override
    public Integer call() throws IOException {
        StartOptions start = Objects.requireNonNull(majic).start();
        try (Program program = start.program(folder, false)) {
            return Console.silent(program).run(start.firstRobots(program), List.of("run \"" + file + "\""));
        }
    }
}
