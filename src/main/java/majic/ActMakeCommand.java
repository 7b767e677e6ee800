package majic;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.ActFile;
import majic.act.ActMaker;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic act make}: a file of classes or of a source. */
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
            description = "a .java source, a .class file in the folder of its package, such a folder, or a jar")
    private Path classes = Path.of("");

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "the file to write; unless said, the act's name with .act, here")
    private @Nullable Path output;

    @Option(names = "--class", paramLabel = "CLASS", description = "which class is the act, if there are several")
    private @Nullable String actClass;

    @Option(names = "--name", paramLabel = "NAME", description = "what it is called; unless said, like its class")
    private @Nullable String name;

    @Option(names = "--author", paramLabel = "WHO", description = "who made it")
    private String author = "";

    @Option(names = "--act-version", paramLabel = "VERSION", description = "the author's own version")
    private String actVersion = "";

    @Option(names = "--description", paramLabel = "TEXT", description = "one or two sentences")
    private String description = "";

    @Override
    public Integer call() throws IOException {
        PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
        try {
            ActMaker maker = ActMaker.from(classes);
            String chosen = actClass == null ? maker.onlyAct() : actClass;
            String called = name == null ? chosen.substring(chosen.lastIndexOf('.') + 1) : name;
            byte[] file = maker.make(chosen, new ActDetails(called, actVersion, author, description));
            Path written = Files.write(output == null ? Path.of(called + ".act") : output, file);
            out.println("wrote " + written);
            ActFile.read(written).describe().forEach(out::println);
            out.flush();
            return 0;
        } catch (ActException e) {
            return Failures.failed(spec.commandLine(), e);
        }
    }
}
