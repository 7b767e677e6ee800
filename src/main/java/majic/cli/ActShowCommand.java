package majic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.act.ActException;
import majic.act.file.ActFile;
import majic.program.Failures;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic act show}: shows the description in an act's file. */
@Command(
        name = "show",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Checks the file of an act and shows what it says of itself; none of its code is loaded.")
final class ActShowCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "the act's file")
    private Path file = Path.of("");

    @Override
    public Integer call() {
        PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
        try {
            ActFile.read(file).describe().forEach(out::println);
            out.flush();
            return 0;
        } catch (ActException e) {
            return Failures.failed(spec.commandLine(), e);
        }
    }
}
