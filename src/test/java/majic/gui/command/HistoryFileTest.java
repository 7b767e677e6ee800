package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HistoryFileTest {
    @TempDir
    private Path folder;

    @Test
    void theLinesOfTwoProgramsAreKeptInOneFile() throws Exception {
        HistoryFile one = new HistoryFile(file());
        HistoryFile other = new HistoryFile(file());
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
        HistoryFile lost = new HistoryFile(folder.resolve("missing/history"));
        lost.append("1 move 5");
        assertThat(read(lost)).isEmpty();
    }

    private Path file() {
        return folder.resolve("history");
    }

    private List<String> read() throws Exception {
        return read(new HistoryFile(file()));
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
