package majic;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Function;
import majic.act.ActDetails;
import majic.act.ActFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** What an act's file is called, where it goes, and what its author says of it; the same for all ways to make one. */
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

    /** Writes the file, and shows what it says of itself. */
    void write(String unlessNamed, Function<ActDetails, byte[]> made, PrintWriter out) throws IOException {
        String called = name == null ? unlessNamed : name;
        byte[] file = made.apply(new ActDetails(called, actVersion, author, description));
        Path written = Files.write(output == null ? Path.of(called + ".act") : output, file);
        out.println("wrote " + written);
        ActFile.read(written).describe().forEach(out::println);
        out.flush();
    }
}
