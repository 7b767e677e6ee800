package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import majic.text.OneSentence;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HistoryFileTest {
    @TempDir
    private Path folder;

    private final List<String> alarms = new CopyOnWriteArrayList<>();

    @Test
    void theLinesOfTwoProgramsAreKeptInOneFile() throws Exception {
        HistoryFile one = new HistoryFile(file(), alarms::add);
        HistoryFile other = new HistoryFile(file(), alarms::add);
        one.append("1 move 5");
        awaitLines(1);
        other.append("2 turn 90°");
        awaitLines(2);
        assertThat(read()).containsExactly("1 move 5", "2 turn 90°");
    }

    @Test
    void aLineOfManyIsReadOnceAtItsNewestPlace() throws Exception {
        Files.write(file(), List.of("a", "b", "", "a", "c"));
        assertThat(read()).containsExactly("b", "a", "c");
    }

    @Test
    void aLongFileIsShortenedToItsNewestLines() throws Exception {
        List<String> lines = IntStream.rangeClosed(1, 2 * History.LONGEST + 1)
                .mapToObj(number -> "line " + number)
                .toList();
        Files.write(file(), lines);
        assertThat(read()).hasSize(History.LONGEST).endsWith("line 1001");
        assertThat(Files.readAllLines(file())).hasSize(History.LONGEST);
    }

    @Test
    void withoutAFolderNoLineIsKeptAndNothingFails() throws Exception {
        HistoryFile lost = new HistoryFile(folder.resolve("missing/history"), alarms::add);
        lost.append("1 move 5");
        assertThat(read(lost)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\0\0\0", "\u00B0"})
    void aDamagedFileIsKeptAndReportedAndItsReadableLinesStay(String damage) throws Exception {
        byte[] damaged = ("1 move 5\n" + damage + "\n2 move 6\n").getBytes(StandardCharsets.ISO_8859_1);
        Files.write(file(), damaged);
        assertThat(read()).containsExactly("1 move 5", "2 move 6");
        assertThat(read()).containsExactly("1 move 5", "2 move 6");

        Path kept = folder.resolve("history.damaged");
        assertThat(Files.readAllBytes(kept)).isEqualTo(damaged);
        assertThat(file()).hasContent("1 move 5\n2 move 6\n");
        SwingUtilities.invokeAndWait(() -> {});
        assertThat(alarms).singleElement().asString().contains("was damaged", kept.toString());
        OneSentence.check(alarms.get(0));
    }

    @Test
    void ofAFileThatIsFarTooLargeTheEndIsRead() throws Exception {
        Files.write(file(), List.of("x".repeat(3_000_000), "1 move 5"));
        assertThat(read()).containsExactly("1 move 5");
        assertThat(file()).hasContent("1 move 5\n");
    }

    private Path file() {
        return folder.resolve("history");
    }

    private List<String> read() throws Exception {
        return read(new HistoryFile(file(), alarms::add));
    }

    private static List<String> read(HistoryFile file) throws Exception {
        CompletableFuture<List<String>> lines = new CompletableFuture<>();
        file.read(lines::complete);
        return lines.get();
    }

    private void awaitLines(int count) throws IOException {
        while (!Files.exists(file()) || Files.readAllLines(file()).size() < count) {
            Thread.onSpinWait();
        }
    }
}
