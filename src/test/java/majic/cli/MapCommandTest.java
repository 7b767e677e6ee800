package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.drivertest.TestClock;
import majic.environment.Settings;
import majic.nav.file.CarmenLog;
import majic.nav.file.MapFiles;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.nav.mapping.Floor;
import majic.program.Failures;
import majic.recorder.RecordedText;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
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
                .setExecutionExceptionHandler((problem, command, parsed) -> Failures.explain(command, problem))
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

    /** Records a robot that drives along a corridor, and returns the file. */
    private Path recording(int robots) throws Exception {
        RecordingFolder recordings = new RecordingFolder(folder.resolve("recordings"));
        try (TestClock clock = new TestClock();
                Team team = new Team(clock.time())) {
            BotFactory factory = new BotFactory(List.of(), Settings.inMemory());
            try (Recorder recorder = new Recorder(team, factory, recordings, problem -> {})) {
                recorder.start();
                List<FakeBot> all = new ArrayList<>();
                for (int number = 1; number <= robots; number++) {
                    FakeBot robot = FakeBot.on(clock.time());
                    robot.equip(Floor.LASER);
                    robot.connect();
                    team.add(robot, OptionalInt.empty());
                    all.add(robot);
                }
                drive(all, clock.time());
            }
        }
        return recordings.files().get(0);
    }

    private static void drive(List<FakeBot> robots, TimeSource time) throws InterruptedException {
        Floor floor = Floor.ring(1);
        for (Pose pose : Floor.around(1).subList(0, 40)) {
            time.sleep(0.25);
            robots.forEach(robot -> robot.measure(floor.scan(Floor.LASER, time.nanos() / 1e9, pose, pose)));
        }
        time.sleep(0.25);
    }

    @Test
    void buildsTheMapFromARecordingAndWritesItAsALog() throws Exception {
        Path recording = recording(1);
        Path log = folder.resolve("drive.clf.gz");

        assertThat(run("build", recording, "--log", log, "--out", folder.resolve("floor")))
                .isZero();
        assertThat(out.toString()).matches("(?s)0 min (09|10) s, 8 m, (39|40) scans of which 20 are in the map.*");
        assertThat(run("build", log, "--out", folder.resolve("again"))).isZero();
        for (String name : List.of("floor.yaml", "again.yaml")) {
            OccupancyGrid grid = MapFiles.read(folder.resolve(name)).grid();
            assertThat(grid.stateAt(6000, 0)).isEqualTo(State.FREE);
            assertThat(grid.stateAt(6000, 3000)).isEqualTo(State.UNKNOWN);
        }
    }

    @Test
    void asksForTheRobotIfARecordingHasScansOfSeveral() throws Exception {
        Path recording = recording(2);

        assertThat(run("build", recording)).isNotZero();
        assertThat(err.toString()).contains(" has scans of robot 1, 2; one of these is right, as in --robot 1");
        assertThat(run("build", recording, "--robot", 3)).isNotZero();
        assertThat(run("build", recording, "--robot", 2)).isZero();
    }

    @Test
    void refusesARecordingWithoutScansInOneSentence() throws Exception {
        Path recording = RecordedText.write(
                folder.resolve("old.majicrec"), "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000");

        assertThat(run("build", recording)).isNotZero();
        assertThat(err.toString())
                .isEqualToIgnoringNewLines("majic: old.majicrec has no scans; a recording of a robot that was driven"
                        + " with a laser scanner would be right, by a MAJIC that records scans");
    }

    @Test
    void refusesAFileThatIsMissingOrNoRecording() throws Exception {
        assertThat(run("build", folder.resolve("none.majicrec"))).isNotZero();
        assertThat(err.toString()).contains("none.majicrec: ");
        Path text = Files.writeString(folder.resolve("text.majicrec"), "a letter");
        assertThat(run("build", text)).isNotZero();
        assertThat(err.toString()).contains("text.majicrec cannot be read: it is no recording of MAJIC");
        assertThat(run("build", log(), "--robot", 1)).isNotZero();
        assertThat(err.toString()).contains("--robot goes with a recording, a file *.majicrec");
    }

    private Path recordingOf(String sensor, String... lines) throws IOException {
        List<String> all = new ArrayList<>(List.of(
                "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000",
                "1.000\trobot\t2\tfan\tFan\tFan\t250\t\t0\t0\t0\t",
                "\tsensor\t2\tfan\t" + sensor));
        all.addAll(List.of(lines));
        return RecordedText.write(folder.resolve("fan.majicrec"), all.toArray(String[]::new));
    }

    private static String scan(int seconds, double x) {
        return "%d.000\tscan\t2\tfan\t%d.000\t%s 0 0\t2000 2100 2200".formatted(seconds, seconds, x);
    }

    @Test
    void takesTheConnectionWithTheMostScansAndSaysSo() throws Exception {
        Path recording = recordingOf(
                "0 0 -30 1 0 8000 15 0 0 0 1 0 8000 15 0 0 30 1 0 8000 15",
                scan(1, 0),
                "\tevent\t2\tlost\tno answer",
                scan(2, 0),
                scan(3, 400),
                "\tevent\t2\tlost\tno answer",
                scan(4, 0));

        assertThat(run("build", recording)).isZero();
        assertThat(out.toString()).startsWith("0 min 01 s, 0 m, 2 scans");
        assertThat(err.toString())
                .startsWith("robot 2 was connected 3 times; the connection with the most scans is read, 2 of 4");
    }

    @Test
    void aScannerThatALogCannotDescribeIsNamed() throws Exception {
        Path recording = recordingOf("0 0 -30 1 0 8000 15 0 0 0 1 0 8000 15 0 0 60 1 0 8000 15", scan(1, 0));
        Path log = folder.resolve("fan.clf");

        assertThat(run("build", recording, "--log", log)).isNotZero();
        assertThat(err.toString()).contains("the beams of the fan are not equally far apart at one place");
        assertThat(log).doesNotExist();
    }

    @Test
    void namesTheMapAfterTheLog() throws IOException {
        assertThat(run("build", log())).isZero();
        assertThat(folder.resolve("ring.yaml")).exists();
    }
}
