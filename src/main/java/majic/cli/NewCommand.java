package majic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.bot.BotException;
import majic.program.Failures;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic new}: writes a small Maven project for a driver or an act, which builds and passes its tests. */
@Command(
        name = "new",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Writes a small Maven project for a robot's driver or for an act.")
public final class NewCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    /** Lists the subcommands when it is called without one. */
    @Override
    public Integer call() {
        command().usage(command().getErr());
        return Failures.USAGE;
    }

    @Command(
            name = "robot",
            mixinStandardHelpOptions = true,
            versionProvider = Version.class,
            description = "Writes a project for the driver of a robot, with the conformance tests of drivers.")
    int robot(
            @Parameters(paramLabel = "NAME", description = "the type of robot, such as Rover") String name,
            @Parameters(arity = "0..1", paramLabel = "FOLDER", description = "default: the name, in lower case")
                    @Nullable
                    Path folder)
            throws IOException {
        return write(ProjectTemplate.robot(), name, folder);
    }

    @Command(
            name = "act",
            mixinStandardHelpOptions = true,
            versionProvider = Version.class,
            description = "Writes a project for an act, with a test in the simulated lab.")
    int act(
            @Parameters(paramLabel = "NAME", description = "the act, such as Explore") String name,
            @Parameters(arity = "0..1", paramLabel = "FOLDER", description = "default: the name, in lower case")
                    @Nullable
                    Path folder)
            throws IOException {
        return write(ProjectTemplate.act(), name, folder);
    }

    private int write(ProjectTemplate template, String name, @Nullable Path folder) throws IOException {
        Path target = folder == null ? Path.of(name.toLowerCase(Locale.ROOT)) : folder;
        try {
            for (Path file : template.write(name, target)) {
                command().getOut().println("wrote " + file);
            }
            command().getOut().println("README.md in it describes how to build it and where MAJIC finds it");
            command().getOut().flush();
            return 0;
        } catch (BotException e) {
            return Failures.failed(command(), e);
        }
    }

    private picocli.CommandLine command() {
        return Objects.requireNonNull(spec).commandLine();
    }
}
