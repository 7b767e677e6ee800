package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.bot.RangeScan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The scans in files of recordings. */
class RecordedScansTest {
    private static final String HEAD = "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000";
    private static final String ROBOT =
            "1.000\trobot\t2\tpioneer\tPioneer\tMobileRobots Pioneer\t250\t\t100\t0\t90\tpioneer";
    private static final String SENSOR = "\tsensor\t2\tlaser\t200 0 -30 1 0 8000 15 200 0 30 1 0 8000 15";
    private static final String CONNECTED = "\tstatus\t2\tconnection\tconnected";

    @TempDir
    private Path folder;

    private Path file(String... lines) throws IOException {
        return RecordedText.write(folder.resolve("a.majicrec"), lines);
    }

    private static String scan(double seconds, String pose, String ranges) {
        return "%.3f\tscan\t2\tlaser\t%.3f\t%s\t%s".formatted(seconds, seconds - 0.1, pose, ranges);
    }

    private static List<RangeScan> read(RecordedScans scans) throws IOException {
        List<RangeScan> all = new ArrayList<>();
        scans.read(all::add);
        return all;
    }

    @Test
    void aScanHasItsTimeItsOdometryAndItsRanges() throws IOException {
        List<RecordedScans> found = RecordedScans.in(file(HEAD, ROBOT, SENSOR, scan(2, "1000.5 -20 12.25", "999 ?")));
        assertThat(found).hasSize(1).first().satisfies(scans -> {
            assertThat(scans.robot().number()).isEqualTo(2);
            assertThat(scans.count()).isEqualTo(1);
        });
        RangeScan scan = read(found.get(0)).get(0);
        assertThat(scan.timeS()).isCloseTo(1.9, within(1e-6));
        assertThat(scan.odometry()).isEqualTo(new Pose(1000.5, -20, 12.25));
        assertThat(scan.sensor().beams().get(1).mount()).isEqualTo(new Pose(200, 0, 30));
        assertThat(scan.rangeMm(0)).isEqualTo(999);
        assertThat(scan.rangeMm(1)).isNaN();
    }

    @Test
    void aConnectionThatWasLostSeparatesTheScans() throws IOException {
        List<RecordedScans> found = RecordedScans.in(file(
                HEAD,
                ROBOT,
                CONNECTED,
                SENSOR,
                scan(2, "0 0 0", "999 clear"),
                scan(3, "100 0 0", "899 clear"),
                "\tevent\t2\tlost\tno answer",
                "\tevent\t2\tregained\tconnected again",
                scan(4, "0 0 0", "499 clear")));
        assertThat(found).extracting(RecordedScans::count).containsExactly(2, 1);
        assertThat(read(found.get(1)))
                .singleElement()
                .satisfies(scan -> assertThat(scan.rangeMm(0)).isEqualTo(499));
    }

    @Test
    void theScansGoOnInTheNextFileOfTheRecording() throws IOException {
        Path first = file(HEAD, ROBOT, CONNECTED, SENSOR, scan(2, "0 0 0", "999 clear"));
        RecordedText.write(
                folder.resolve("b.majicrec"),
                HEAD.replace("\t1\t0.000", "\t2\t3.000"),
                ROBOT,
                CONNECTED,
                SENSOR,
                scan(4, "100 0 0", "899 clear"));
        List<RecordedScans> found = RecordedScans.in(first);
        assertThat(found).extracting(RecordedScans::count).containsExactly(2);
        assertThat(read(found.get(0))).extracting(RangeScan::timeS).containsExactly(1.9, 3.9);
    }

    @Test
    void anOlderRecordingHasNone() throws IOException {
        assertThat(RecordedScans.in(file(HEAD, ROBOT))).isEmpty();
    }

    @Test
    void aReplayHasTheScansOfEachRobot() throws IOException {
        Recording recording = Recording.read(file(HEAD, ROBOT, SENSOR, scan(2, "0 0 0", "999 clear")));
        assertThat(recording.endS()).isEqualTo(2);
        assertThat(recording.tracks().get(0).scans())
                .singleElement()
                .satisfies(scan -> assertThat(scan.rangeMm(0)).isEqualTo(999));
    }

    @Test
    void whatIsDamagedIsNamedWithItsPlace() throws IOException {
        Stream.of(
                        scan(2, "0 0 0", "1 2 3"),
                        scan(2, "0 0", "1 2"),
                        scan(2, "0 1e300 0", "1 2"),
                        scan(2, "0 0 NaN", "1 2"),
                        scan(2, "0 0 0", "1 near"),
                        scan(2, "0 0 0", "1 2").replace("laser", "radar"),
                        "2.000\tscan\t2\tlaser",
                        "\tsensor\t2\tlaser\t1 2 3",
                        "\tsensor\t2\tlaser\t0 0 0 1 9 8 1")
                .forEach(damaged -> assertThatThrownBy(
                                () -> RecordedScans.in(file(HEAD, ROBOT, SENSOR, damaged, CONNECTED)))
                        .isInstanceOf(IOException.class)
                        .hasMessageMatching("a\\.majicrec cannot be read: it is damaged in line 4: \\P{Cntrl}+"));
    }

    @Test
    void aMissingFileAndAnotherOneAreRefused() throws IOException {
        assertThatThrownBy(() -> RecordedScans.in(folder.resolve("none.majicrec")))
                .isInstanceOf(NoSuchFileException.class);
        Path other = Files.writeString(folder.resolve("c.majicrec"), "a letter");
        assertThatThrownBy(() -> RecordedScans.in(other))
                .hasMessage("c.majicrec cannot be read: it is no recording of MAJIC, or it is damaged");
    }
}
