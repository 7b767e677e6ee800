package majic.cli;

import java.util.concurrent.Callable;
import majic.program.Failures;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code majic act}: the act maker on the command line. */
@Command(
        name = "act",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Makes files of acts and shows what is in them.",
        subcommands = {ActMakeCommand.class, ActFromSessionCommand.class, ActShowCommand.class})
public final class ActCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    /** Lists the subcommands when it is called without one. */
    @Override
    public Integer call() {
        if (spec != null) {
            spec.commandLine().usage(spec.commandLine().getErr());
        }
        return Failures.USAGE;
    }
}
