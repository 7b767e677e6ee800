package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import majic.bot.Parameter;
import majic.bot.RangeScan;
import majic.text.OneSentence;
import org.junit.jupiter.api.io.TempDir;

/** Arbitrary recordings: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class RecordingFuzzTest {
    @TempDir
    private Path folder;

    @FuzzTest
    void anyFileIsReadOrRefusedWithAReason(byte[] file) throws IOException {
        readOrRefused(file);
    }

    @FuzzTest
    void anyLinesAreReadOrRefusedWithTheirPlace(byte[] lines) throws IOException {
        readOrRefused(compressed(lines));
    }

    @FuzzTest
    void anyScansAreReadOrRefusedWithTheirPlace(byte[] lines) throws IOException {
        Path file = file(compressed(lines));
        try {
            for (RecordedScans scans : RecordedScans.in(file)) {
                List<RangeScan> read = new ArrayList<>();
                scans.read(read::add);
                assertThat(read).hasSize(scans.count());
            }
        } catch (IOException e) {
            assertThat(e).hasMessageStartingWith("odd.majicrec cannot be read: it");
            OneSentence.check(e.getMessage());
        }
    }

    @FuzzTest
    void aFileThatIsCutOffHasWhatIsInFrontOfTheCut(byte[] lines) throws IOException {
        Recording whole;
        try {
            whole = Recording.read(file(compressed(lines)));
        } catch (IOException e) {
            return;
        }
        int head = new String(lines, StandardCharsets.ISO_8859_1).indexOf('\n') + 1;
        if (head == 0) {
            return;
        }
        for (int cut : new int[] {lines.length, (head + lines.length) / 2, head}) {
            Recording part = Recording.read(file(compressed(Arrays.copyOf(lines, cut))));

            assertThat(part.lines())
                    .isEqualTo(whole.lines().subList(0, part.lines().size()));
            assertThat(whole.head()).isEqualTo(part.head());
        }
    }

    private void readOrRefused(byte[] file) throws IOException {
        try {
            show(Recording.read(file(file)));
        } catch (IOException e) {
            assertThat(e).hasMessageStartingWith("it");
            OneSentence.check(e.getMessage());
        }
    }

    /** Reads all that a replay shows. */
    private static void show(Recording recording) {
        double end = recording.endS();
        assertThat(recording.head().timeOfDay(end))
                .isAfterOrEqualTo(recording.head().begin());
        assertThat(recording.truePoses(end)).doesNotContainValue(null);
        assertThat(recording.marks(0)).doesNotContainNull();
        for (RobotTracks robot : recording.tracks()) {
            for (Parameter parameter : robot.parameters()) {
                assertThat(robot.value(parameter, end).toString()).isNotNull();
                Series series = recording.series(robot.robot().number(), parameter.name(), 0);
                assertThat(series.seconds()).hasSameSizeAs(series.values()).isSorted();
            }
            assertThat(robot.origin(end)).isNotNull();
            assertThat(robot.picture(end)).isNotNull();
            assertThat(robot.reports(end)).isNotNull();
            assertThat(robot.changes(recording.beginS(), end)).isSorted();
        }
    }

    private Path file(byte[] content) throws IOException {
        return Files.write(folder.resolve("odd.majicrec"), content);
    }

    private static byte[] compressed(byte[] text) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream out = new GZIPOutputStream(bytes)) {
            out.write(text);
        }
        return bytes.toByteArray();
    }
}
