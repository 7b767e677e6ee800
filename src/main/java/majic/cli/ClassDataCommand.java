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
 * {@code majic class-data}: performs complete starts without showing anything, first without a lab and then with one.
 * The launcher runs it once in the background, so that the Java machine records the classes that later starts need.
 * With a lab it stops the robots too: the first STOP of a program must not wait until classes are loaded.
 */
@Command(name = "class-data", hidden = true, description = "Rehearses a start, for the launcher.")
public final class ClassDataCommand implements Callable<Integer> {
    private static final List<String> ROBOTS =
            List.of("add sim:aibo", "add sim:pioneer", "add sim:hemisson", "all get x");

    @Override
    public Integer call() throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("majic-class-data");
        try {
            if (!GraphicsEnvironment.isHeadless()) {
                Window.preload();
            }
            rehearse(new Program(new UserFolder(folder), null, true), List.of());
            SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
            rehearse(new Program(new UserFolder(folder), lab, true), ROBOTS);
            return 0;
        } finally {
            delete(folder);
        }
    }

    private static void rehearse(Program rehearsed, List<String> lines) throws InterruptedException {
        try (Program program = rehearsed) {
            program.closeWhenProgramEnds();
            MajicParser parser = MajicParser.pipe(program.session());
            lines.forEach(parser::parseText);
            parser.awaitAll();
            program.team().stopAllIfAny();
            program.team().release();
            if (!GraphicsEnvironment.isHeadless()) {
                new Window(program).rehearse();
            }
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
