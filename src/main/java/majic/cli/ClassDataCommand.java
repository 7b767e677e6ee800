package majic.cli;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.Window;
import majic.script.MajicParser;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import picocli.CommandLine.Command;

/**
 * {@code majic class-data}: performs a complete start without showing anything. The launcher runs it once in the
 * background, so that the Java machine records the classes that later starts need.
 */
@Command(name = "class-data", hidden = true, description = "Rehearses a start, for the launcher.")
public final class ClassDataCommand implements Callable<Integer> {
    @Override
    public Integer call() throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("majic-class-data");
        try (Program program =
                new Program(new UserFolder(folder), SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1), true)) {
            MajicParser parser = new MajicParser(program.session(), false);
            for (String line : List.of("add sim:aibo", "add sim:pioneer", "add sim:hemisson", "all get x")) {
                parser.parseText(line);
            }
            parser.awaitAll();
            if (!GraphicsEnvironment.isHeadless()) {
                new Window(program).rehearse();
            }
            return 0;
        } finally {
            delete(folder);
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
