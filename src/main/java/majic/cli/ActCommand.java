package majic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.act.make.ActMaker;
import majic.bot.BotException;
import majic.program.Failures;
import majic.program.Version;
import majic.script.ScriptAct;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * {@code majic act}: the act maker on the command line. It makes an act's file of classes, of a source, of a script or
 * of a saved session, and shows the description in such a file.
 */
@Command(
        name = "act",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Makes files of acts and shows what is in them.")
public final class ActCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    /** Lists the subcommands when it is called without one. */
    @Override
    public Integer call() {
        command().usage(command().getErr());
        return Failures.USAGE;
    }

    @Command(
            name = "make",
            mixinStandardHelpOptions = true,
            versionProvider = Version.class,
            sortOptions = false,
            description =
                    "Makes the file of an act. The act's constructor runs once, here, so that its object can be saved.")
    int make(
            @Parameters(
                            paramLabel = "CLASSES",
                            description =
                                    "a .java source, a .class file in the folder of its package, such a folder, a jar, or a script")
                    Path classes,
            @Option(
                            names = "--class",
                            paramLabel = "CLASS",
                            description = "which class is the act, if there are several")
                    @Nullable
                    String actClass,
            @Mixin ActOutput output)
            throws IOException {
        return reported(() -> {
            if (!ActCatalog.isScript(classes.toString())) {
                ActMaker maker = ActMaker.from(classes);
                String chosen = actClass == null ? maker.onlyAct() : actClass;
                output.write(
                        chosen.substring(chosen.lastIndexOf('.') + 1), details -> maker.make(chosen, details), out());
            } else if (actClass == null) {
                makeOfScript(classes, output);
            } else {
                throw new BotException("--class " + actClass + ": a script has no classes");
            }
        });
    }

    @Command(
            name = "from-session",
            mixinStandardHelpOptions = true,
            versionProvider = Version.class,
            sortOptions = false,
            description = "Makes the file of an act from a saved session or a script. Each robot in it becomes a role.")
    int fromSession(
            @Parameters(paramLabel = "SCRIPT", description = "the saved session or script") Path script,
            @Mixin ActOutput output)
            throws IOException {
        return reported(() -> makeOfScript(script, output));
    }

    private void makeOfScript(Path script, ActOutput output) throws IOException {
        ScriptAct act = ScriptAct.read(script);
        output.write(act.title().replaceFirst("\\.[^.]*$", ""), details -> ActMaker.save(act, details), out());
    }

    @Command(
            name = "show",
            mixinStandardHelpOptions = true,
            versionProvider = Version.class,
            description = "Checks the file of an act and shows what it says of itself; none of its code is loaded.")
    int show(@Parameters(paramLabel = "FILE", description = "the act's file") Path file) throws IOException {
        return reported(() -> {
            ActFile.read(file).describe().forEach(out()::println);
            out().flush();
        });
    }

    /** The work of a subcommand. */
    private interface Work {
        void run() throws IOException;
    }

    /** Returns the exit status of a subcommand, and prints in one sentence why it has failed. */
    private int reported(Work work) throws IOException {
        try {
            work.run();
            return 0;
        } catch (BotException e) {
            return Failures.failed(command(), e);
        }
    }

    private PrintWriter out() {
        return command().getOut();
    }

    private CommandLine command() {
        return Objects.requireNonNull(spec).commandLine();
    }
}
