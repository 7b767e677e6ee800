package majic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.act.file.ActCatalog;
import majic.act.make.ActMaker;
import majic.bot.BotException;
import majic.console.ActOutput;
import majic.program.Failures;
import majic.program.Version;
import majic.script.ScriptAct;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic act make}: makes an act's file of classes, of a source or of a script. */
@Command(
        name = "make",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description =
                "Makes the file of an act. The act's constructor runs once, here, so that its object can be saved.")
final class ActMakeCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    @Parameters(
            paramLabel = "CLASSES",
            description =
                    "a .java source, a .class file in the folder of its package, such a folder, a jar, or a script")
    private Path classes = Path.of("");

    @Option(names = "--class", paramLabel = "CLASS", description = "which class is the act, if there are several")
    private @Nullable String actClass;

    @Mixin
    private ActOutput output = new ActOutput();

    @Override
    public Integer call() throws IOException {
        try {
            if (ActCatalog.isScript(classes.toString())) {
                makeOfScript();
                return 0;
            }
            ActMaker maker = ActMaker.from(classes);
            String chosen = actClass == null ? maker.onlyAct() : actClass;
            output.write(
                    chosen.substring(chosen.lastIndexOf('.') + 1),
                    details -> maker.make(chosen, details),
                    Objects.requireNonNull(spec).commandLine().getOut());
            return 0;
        } catch (BotException e) {
            return Failures.failed(Objects.requireNonNull(spec).commandLine(), e);
        }
    }

    private void makeOfScript() throws IOException {
        if (actClass != null) {
            throw new BotException("--class " + actClass + ": a script has no classes");
        }
        ScriptAct act = ScriptAct.read(classes);
        output.write(
                act.title().replaceFirst("\\.[^.]*$", ""),
                details -> ActMaker.save(act, details),
                Objects.requireNonNull(spec).commandLine().getOut());
    }
}
