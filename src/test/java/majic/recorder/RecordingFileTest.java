package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.GZIPOutputStream;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingFileTest {
    private static final String HEAD = "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000\n";
    private static final String ROBOT =
            "1.000\trobot\t2\tpioneer\tPioneer\tMobileRobots Pioneer\t250\t\t100\t0\t90\tpioneer\n";
    private static final String X = "\tparameter\t2\tx\tnumber\tmm\t\t-1.0E9\t1.0E9\tahead\n";

    @TempDir
    private Path folder;

    private Path file(String... lines) throws IOException {
        return file(bytes(lines));
    }

    private Path file(byte[] bytes) throws IOException {
        return Files.write(folder.resolve("a.majicrec"), bytes);
    }

    private static byte[] bytes(String... lines) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream out = new GZIPOutputStream(bytes)) {
            out.write(String.join("", lines).getBytes(StandardCharsets.UTF_8));
        }
        return bytes.toByteArray();
    }

    @Test
    void aLineWithoutATimeHasThatOfTheLineBefore() throws Exception {
        Series x = Recording.read(file(HEAD, ROBOT, X, "\tvalue\t2\tx\t5\n", "1.250\tvalue\t2\tx\t7.5\n"))
                .series(2, "x", 0);
        assertThat(x.seconds()).containsExactly(1, 1.25);
        assertThat(x.values()).containsExactly(5, 7.5);
    }

    @Test
    void aValueHoldsUntilTheNextOne() throws Exception {
        RobotTracks robot = Recording.read(
                        file(HEAD, ROBOT, X, "2.000\tvalue\t2\tx\t5\n", "4.000\tvalue\t2\tx\t?no reading yet\n"))
                .tracks()
                .get(0);
        Parameter x = robot.parameters().get(0);
        assertThat(robot.value(x, 1.5)).isInstanceOf(Value.Unknown.class);
        assertThat(robot.value(x, 3.9)).isEqualTo(Value.of(5, Unit.MM));
        assertThat(robot.value(x, 4)).hasToString("unknown (no reading yet)");
    }

    @Test
    void aRobotWithoutReadingsStaysWhereItWas() throws Exception {
        RobotTracks robot = Recording.read(
                        file(HEAD, ROBOT, X, "2.000\tvalue\t2\tx\t5\n", "4.000\tvalue\t2\tx\t?no reading yet\n"))
                .tracks()
                .get(0);
        assertThat(robot.pose(1.5)).isEqualTo(Pose.START);
        assertThat(robot.pose(3.9)).isEqualTo(new Pose(5, 0, 0));
        assertThat(robot.pose(4)).isEqualTo(new Pose(5, 0, 0));
    }

    @Test
    void aWayHoldsUntilTheNextOne() throws Exception {
        RobotTracks robot = Recording.read(file(
                        HEAD,
                        ROBOT,
                        "2.000\tstatus\t2\tway\t700 0 700 -300\n",
                        "4.000\tstatus\t2\tway\t\n",
                        "5.000\tstatus\t2\tstop\t\n"))
                .tracks()
                .get(0);
        assertThat(robot.way(1.5)).isEmpty();
        assertThat(robot.way(3.9)).containsExactly(new Pose(700, 0, 0), new Pose(700, -300, 0));
        assertThat(robot.way(4)).isEmpty();
    }

    @Test
    void aWayThatHasHalfACornerIsDamaged() throws Exception {
        Path damaged = file(HEAD, ROBOT, "2.000\tstatus\t2\tway\t700 0 700\n", X);
        assertThatThrownBy(() -> Recording.read(damaged))
                .hasMessage("it is damaged in line 3: a way has 3 numbers and needs two for each corner");
    }

    @Test
    void aNumberUsedAgainIsAnotherRobot() throws Exception {
        Recording recording = Recording.read(
                file(HEAD, ROBOT, "3.000\tevent\t2\tremoved\tPioneer\n", ROBOT.replace("1.000", "5.000")));
        assertThat(recording.robots()).extracting(RecordedRobot::addedS).containsExactly(1.0, 5.0);
        assertThat(recording.tracks().get(0).isPresent(4)).isFalse();
        assertThat(recording.tracks().get(1).isPresent(5)).isTrue();
    }

    @Test
    void aFileIsReadUpToTheEndThatIsMissing() throws Exception {
        StringBuilder values = new StringBuilder();
        for (int second = 2; second < 5000; second++) {
            values.append(second)
                    .append(".000\tvalue\t2\tx\t")
                    .append(second * 7919 % 10_007)
                    .append('\n');
        }
        byte[] whole = bytes(HEAD, ROBOT, X, values.toString());
        byte[] cut = Arrays.copyOf(whole, whole.length * 3 / 4);
        Recording recording = Recording.read(file(cut));
        assertThat(recording.series(2, "x", 0).size()).isBetween(3000, 4998);
    }

    @Test
    void aLastLineThatIsCutOffIsLeftOut() throws Exception {
        Recording recording = Recording.read(file(HEAD, ROBOT, X, "2.000\tvalue\t2\tx\t5\n", "3.000\tval"));
        assertThat(recording.series(2, "x", 0).values()).containsExactly(5);
    }

    @Test
    void aNumberThatIsCutOffInTheLastLineIsNotAnother() throws Exception {
        Recording recording = Recording.read(file(HEAD, ROBOT, X, "2.000\tvalue\t2\tx\t5\n", "3.000\tvalue\t2\tx\t12"));
        assertThat(recording.series(2, "x", 0).values()).containsExactly(5);
    }

    @Test
    void aLineThatWouldFillTheMemoryIsRefused() throws Exception {
        Path bomb = file(HEAD, ROBOT, "x".repeat(1 << 21));
        assertThatThrownBy(() -> Recording.read(bomb)).hasMessage("it is damaged: it has a line of more than 1 MB");
    }

    @Test
    void aTimeThatIsNoneIsNamed() throws Exception {
        Path damaged = file(HEAD, ROBOT, "NaN\tvalue\t2\tx\t5\n", X);
        assertThatThrownBy(() -> Recording.read(damaged)).hasMessage("it is damaged in line 3: \"NaN\" is not a time");
    }

    @Test
    void linesOfAKindThatIsNotKnownAreSkipped() throws Exception {
        assertThat(Recording.read(file(HEAD, ROBOT, "2.000\tlaser\t2\t1 2 3\n")).robots())
                .hasSize(1);
    }

    @Test
    void otherFilesAreRefusedWithTheReason() throws Exception {
        Path text = Files.writeString(folder.resolve("text"), "a letter");
        assertThatThrownBy(() -> Recording.read(text)).hasMessage("it is no recording of MAJIC, or it is damaged");
        Path other = file("some other compressed text\n");
        assertThatThrownBy(() -> Recording.read(other)).hasMessage("it is no recording of MAJIC");
        Path empty = Files.createFile(folder.resolve("empty"));
        assertThatThrownBy(() -> Recording.read(empty)).hasMessage("it is empty");
    }

    @Test
    void aRecordingOfALaterFormatIsRefused() throws Exception {
        Path later = file(HEAD.replace("\t1\t2026", "\t9\t2026"));
        assertThatThrownBy(() -> Recording.read(later)).hasMessageContaining("another version of MAJIC (format 9");
    }

    @Test
    void aDamagedLineIsNamed() throws Exception {
        Path damaged = file(HEAD, ROBOT, "2.000\tvalue\ttwo\tx\t5\n", X);
        assertThatThrownBy(() -> Recording.read(damaged)).hasMessageStartingWith("it is damaged in line 3: ");
    }
}
