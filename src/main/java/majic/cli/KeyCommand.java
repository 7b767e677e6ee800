package majic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.program.UserFolder;
import majic.program.Version;
import majic.server.ListenKey;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code majic key}: makes the key with which programs on other computers recognise this MAJIC. */
@Command(
        name = "key",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Makes the key that --listen needs for programs on other computers, and its certificate.")
public final class KeyCommand implements Callable<Integer> {
    private final UserFolder folder;

    @Spec
    private @Nullable CommandSpec spec;

    public KeyCommand(UserFolder folder) {
        this.folder = folder;
    }

    @Override
    public Integer call() throws IOException {
        ListenKey.create(folder.path());
        PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
        out.println("made the key " + folder.file(ListenKey.FILE) + ", which stays on this computer,");
        out.println("and its certificate " + folder.file(ListenKey.CERTIFICATE) + ": copy it to the other computers");
        out.flush();
        return 0;
    }
}
