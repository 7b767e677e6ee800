package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.nav.file.CarmenLog;
import majic.nav.mapping.Floor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Maps on the command line: built from a log, shown, or refused in one sentence. */
class MapCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(Object... words) {
        String[] line = Stream.of(words).map(Object::toString).toArray(String[]::new);
        return new CommandLine(new MapCommand())
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(line);
    }

    private Path log() throws IOException {
        Floor floor = Floor.ring(1);
        List<Pose> way = Floor.around(1).subList(0, 40);
        StringBuilder log = new StringBuilder();
        for (int index = 0; index < way.size(); index++) {
            log.append(CarmenLog.line(index, way.get(index))).append('\n');
            log.append(CarmenLog.line(floor.scan(Floor.LASER, index + 0.5, way.get(index), way.get(index))))
                    .append('\n');
        }
        return Files.writeString(folder.resolve("ring.log"), log);
    }

    @Test
    void buildsAMapFromALogAndShowsIt() throws IOException {
        Path way = folder.resolve("way.txt");

        assertThat(run("build", log(), "--out", folder.resolve("floor"), "--trajectory", way))
                .isZero();
        assertThat(out.toString()).contains("0 min 39 s, 8 m, 40 scans of which 20 are in the map");
        assertThat(err.toString()).contains("100 %: ");
        assertThat(Files.readAllLines(way)).hasSize(80).first().asString().startsWith("0.000000 0.000000 0.000000 0.0");
        assertThat(folder.resolve("floor.pgm")).exists();

        assertThat(run("show", folder.resolve("floor.yaml"))).isZero();
        assertThat(out.toString()).contains("cells of 50 mm; free ", "lower left corner at ");
    }

    @Test
    void showsWhatIsInALog() throws IOException {
        assertThat(run("show", log())).isZero();
        assertThat(out.toString()).contains("40 lines of odometry, 40 scans, 40 s");
    }

    @Test
    void namesTheMapAfterTheLog() throws IOException {
        assertThat(run("build", log())).isZero();
        assertThat(folder.resolve("ring.yaml")).exists();
    }
}
