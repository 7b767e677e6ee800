package majic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
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
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic act from-session}: makes an act's file of a saved session or a script. */
@Command(
        name = "from-session",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description = "Makes the file of an act from a saved session or a script. Each robot in it becomes a role.")
final class ActFromSessionCommand implements Callable<Integer> {
    @Spec
    private @Nullable CommandSpec spec;

    @Parameters(paramLabel = "SCRIPT", description = "the saved session or script")
    private Path script = Path.of("");

    @Mixin
    private ActOutput output = new ActOutput();

    @Override
    public Integer call() throws IOException {
        try {
            ScriptAct act = ScriptAct.read(script);
            output.write(
                    act.title().replaceFirst("\\.[^.]*$", ""),
                    details -> ActMaker.save(act, details),
                    Objects.requireNonNull(spec).commandLine().getOut());
            return 0;
        } catch (BotException e) {
            return Failures.failed(Objects.requireNonNull(spec).commandLine(), e);
        }
    }
}
