package majic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Function;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.bot.BotException;
import majic.file.WholeFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options for an act's file: its name, its place, and its author's description; the same for all ways to make one. */
final class ActOutput {
    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "the file to write; unless said, the act's name with .act, here")
    private @Nullable Path output;

    @Option(names = "--name", paramLabel = "NAME", description = "what it is called; unless said, like what it is of")
    private @Nullable String name;

    @Option(names = "--author", paramLabel = "WHO", description = "who made it")
    private String author = "";

    @Option(names = "--act-version", paramLabel = "VERSION", description = "the author's own version")
    private String actVersion = "";

    @Option(names = "--description", paramLabel = "TEXT", description = "one or two sentences")
    private String description = "";

    /** Writes the file, and shows its description. */
    void write(String unlessNamed, Function<ActDetails, byte[]> made, PrintWriter out) throws IOException {
        String called = name == null ? unlessNamed : name;
        byte[] file = made.apply(new ActDetails(called, actVersion, author, description));
        Path written = output == null ? Path.of(called + ".act") : output;
        save(file, written);
        out.println("wrote " + written);
        ActFile.read(written).describe().forEach(out::println);
        out.flush();
    }

    private static void save(byte[] file, Path target) throws IOException {
        Path folder = target.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new BotException(target + ": there is no folder " + folder);
        }
        if (Files.isDirectory(target)) {
            throw new BotException(target + ": is a folder; name the file in it, such as "
                    + target.resolve("Patrol" + ActCatalog.ENDING).normalize());
        }
        WholeFile.replace(target, file);
    }
}
