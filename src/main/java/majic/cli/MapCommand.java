package majic.cli;

import java.util.concurrent.Callable;
import majic.program.Failures;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code majic map}: maps of buildings on the command line. */
@Command(
        name = "map",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Builds maps from logs and shows what is in files of maps.",
        subcommands = {MapBuildCommand.class, MapShowCommand.class})
public final class MapCommand implements Callable<Integer> {
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
