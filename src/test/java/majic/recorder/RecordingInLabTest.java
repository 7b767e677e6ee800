package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.nav.path.Way;
import majic.tool.Tool;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What three robots of the lab report, and what is done with them, is in the recording. */
class RecordingInLabTest {
    private static final Path PYTHON = Path.of("examples", "recording.py");

    @TempDir
    private Path folder;

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final List<String> troubles = Collections.synchronizedList(new ArrayList<>());
    private Recorder recorder;

    @BeforeEach
    void record() {
        recorder = new Recorder(
                rig.team(),
                rig.session().factory(),
                new RecordingFolder(folder.resolve("recordings")),
                troubles::add,
                robot -> rig.session()
                        .map()
                        .navigator()
                        .way(robot)
                        .map(Way::points)
                        .orElse(List.of()));
        rig.session().addListener(recorder);
        recorder.start();
        rig.withAllRobots();
    }

    private Recording closed() throws IOException {
        rig.session().flush();
        recorder.close();
        assertThat(troubles).isEmpty();
        assertThat(recorder.dropped()).isZero();
        List<Path> files = new RecordingFolder(folder.resolve("recordings")).files();
        assertThat(files).hasSize(1);
        return Recording.read(files.get(0));
    }

    @Test
    void everyRobotIsRecordedWithItsPlaceInTheRoom() throws Exception {
        rig.run("wait 1s");
        Recording recording = closed();
        assertThat(recording.robots()).extracting(RecordedRobot::type).containsExactly("aibo", "pioneer", "hemisson");
        assertThat(recording.room().walls()).isNotEmpty();
        RecordedRobot pioneer = recording.robots().get(1);
        assertThat(recording.truePoses(recording.endS()).get(pioneer.inLab()).distanceMm(pioneer.origin()))
                .isLessThan(1);
    }

    @Test
    void aMoveIsInTheSeriesOfX() throws Exception {
        rig.run("2 move 300");
        Series x = closed().series(2, "X", 0);
        assertThat(x.values()[0]).isZero();
        assertThat(x.values()[x.size() - 1]).isBetween(285.0, 315.0);
        assertThat(x.size()).isGreaterThan(10);
        assertThat(x.seconds()).isSorted();
    }

    @Test
    void theWayToAPlaceIsRecordedWhileTheRobotDrivesThere() throws Exception {
        rig.run("2 goto 600 0");
        rig.run("wait 1s");
        Recording recording = closed();
        RobotTracks pioneer = recording.tracks().get(1);
        double begunS = recording.marks(0).stream()
                .filter(mark -> mark.kind() == Mark.Kind.BEGUN)
                .mapToDouble(Mark::seconds)
                .min()
                .orElseThrow();
        assertThat(pioneer.way(begunS - 0.1)).isEmpty();
        assertThat(pioneer.way(begunS + 1)).last().isEqualTo(new Pose(600, 0, 0));
        assertThat(pioneer.way(recording.endS())).isEmpty();
    }

    @Test
    void theRunningRecordingCanBeReadAlready() throws Exception {
        rig.run("2 move 100");
        RecordedHistory history = recorder.history();
        Series x = history.series(2, "x", 0);
        assertThat(x.values()[x.size() - 1]).isBetween(85.0, 115.0);
        assertThat(history.parameters(2)).extracting(Parameter::name).contains("x", "sonar0", "voltage");
        assertThat(history.robots()).hasSize(3);
        assertThat(history.endS()).isGreaterThanOrEqualTo(x.seconds()[x.size() - 1]);
        recorder.close();
    }

    @Test
    void aSeriesBeginsWithTheValueInForce() throws Exception {
        rig.run("2 move 100", "wait 2s");
        Recording recording = closed();
        Series late = recording.series(2, "x", recording.endS());
        assertThat(late.values()).hasSize(1);
        assertThat(late.values()[0]).isBetween(85.0, 115.0);
    }

    @Test
    void oneValueOfAListIsASeriesToo() throws Exception {
        rig.run("2 move 100");
        RecordedHistory history = recorder.history();
        Series whole = history.series(2, "sonar3", 0);
        Series item = history.series(2, "sonar[3]", 0);
        assertThat(item.values()[item.size() - 1]).isEqualTo(whole.values()[whole.size() - 1]);
        Recording recording = closed();
        Parameter sonar = recording.parameters(2).stream()
                .filter(parameter -> parameter.name().equals("sonar"))
                .findFirst()
                .orElseThrow();
        assertThat(recording.tracks().get(1).value(sonar, recording.endS())).isInstanceOf(Value.Many.class);
    }

    @Test
    void commandsAndStopsAreMarked() throws Exception {
        rig.run("2 move 300");
        rig.say("2 turn 90");
        rig.await(() -> rig.team().member(2).bot().state().moving());
        rig.lab().time().sleep(0.5);
        rig.run("2 stop");
        Recording recording = closed();
        assertThat(recording.marks(0))
                .extracting(Mark::kind)
                .contains(Mark.Kind.ADDED, Mark.Kind.ENDED, Mark.Kind.STOP);
        assertThat(recording.marks(0))
                .filteredOn(mark -> mark.kind() == Mark.Kind.BEGUN)
                .extracting(Mark::text)
                .containsExactly("2 move 300", "2 turn 90");
        assertThat(recording.lines()).extracting(RecordedLine::text).contains("2 move 300");
    }

    @Test
    void twoEqualCommandsHaveAMarkEach() throws Exception {
        rig.run("2 move 100", "2 move 100");
        assertThat(closed().marks(0))
                .filteredOn(mark -> mark.kind() == Mark.Kind.BEGUN)
                .extracting(Mark::text)
                .containsExactly("2 move 100", "2 move 100");
    }

    @Test
    void aLostConnectionIsRecorded() throws Exception {
        rig.lab().simulators().faults("pioneer").cut();
        rig.await(() -> !rig.team().member(2).bot().isConnected());
        rig.run("wait 1s");
        Recording recording = closed();
        RobotTracks pioneer = recording.tracks().get(1);
        assertThat(pioneer.status("connection", recording.endS())).isEqualTo("lost");
        assertThat(recording.marks(0)).extracting(Mark::kind).contains(Mark.Kind.LOST);
    }

    @Test
    void aRobotThatWasPlacedHasThePoseOfTheMap() throws Exception {
        rig.run("2 set pose 700 300 90");
        RobotTracks pioneer = closed().tracks().get(1);
        assertThat(pioneer.origin(pioneer.robot().addedS()))
                .isEqualTo(pioneer.robot().origin());
        assertThat(pioneer.origin(recorder.seconds())).isEqualTo(Pose.START);
    }

    @Test
    void recordingRequestsNothingFromARobot() throws Exception {
        rig.run("wait 5s");
        Recording recording = closed();
        RobotTracks hemisson = recording.tracks().get(2);
        Parameter pin = hemisson.parameters().stream()
                .filter(parameter -> parameter.name().equals("pinRB0"))
                .findFirst()
                .orElseThrow();
        assertThat(hemisson.value(pin, recording.endS())).hasToString("unknown (no reading yet)");
    }

    @Test
    void aFullFileIsFollowedByOneThatCanBeReadAlone() throws Exception {
        RecordingFolder small = new RecordingFolder(folder.resolve("small"), 1_000_000, 1000);
        try (Recorder second = new Recorder(rig.team(), rig.session().factory(), small, troubles::add)) {
            second.start();
            rig.run("2 move 100");
            second.history().marks(0);
            rig.run("2 move 100");
            Series x = second.history().series(2, "x", 0);
            assertThat(x.values()[0]).isZero();
            assertThat(x.values()[x.size() - 1]).isBetween(185.0, 215.0);
            assertThat(x.seconds()).isSorted();
        }
        List<Recording> parts = parts(small);
        assertThat(parts).hasSizeGreaterThanOrEqualTo(2);
        for (int number = 1; number <= parts.size(); number++) {
            assertThat(parts.get(number - 1).head().part()).isEqualTo(number);
            canBeReadAlone(parts.get(number - 1));
        }
        assertThat(parts)
                .anySatisfy(
                        part -> assertThat(part.series(2, "x", 0).values()[0]).isBetween(85.0, 115.0));
        recorder.close();
    }

    private static List<Recording> parts(RecordingFolder from) throws IOException {
        List<Recording> parts = new ArrayList<>();
        for (Path file : from.files()) {
            parts.add(Recording.read(file));
        }
        return parts;
    }

    private static void canBeReadAlone(Recording part) {
        assertThat(part.robots()).hasSize(3);
        assertThat(part.room().walls()).isNotEmpty();
        assertThat(part.series(2, "x", 0).values()).isNotEmpty();
        assertThat(part.series(3, "x", 0).values()).isNotEmpty();
    }

    @Test
    void thePageShowsTheProgramInPythonAsItIs() throws Exception {
        assertThat(Files.readString(Path.of("docs", "recordings.md"))).contains(Files.readString(PYTHON));
    }

    @Test
    void theProgramInPythonReadsARecordingThatIsStillWritten() throws Exception {
        Tool.require("python3");
        rig.run("2 move 100");
        Series x = recorder.history().series(2, "x", 0);
        Path file = new RecordingFolder(folder.resolve("recordings")).files().get(0);
        String[] printed = Tool.run("python3", PYTHON.toString(), file.toString(), "2", "x")
                .strip()
                .split("\\R");
        assertThat(printed).hasSizeGreaterThanOrEqualTo(x.size());
        String[] last = printed[printed.length - 1].split(" ");
        assertThat(Double.parseDouble(last[1])).isBetween(85.0, 115.0);
        recorder.close();
    }
}
