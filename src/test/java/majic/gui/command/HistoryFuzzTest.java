package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.text.OneSentence;
import org.junit.jupiter.api.io.TempDir;

/**
 * Arbitrary command histories: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md).
 */
class HistoryFuzzTest {
    /** A line end, or a character that a command line cannot show. */
    private static final String UNREADABLE = ".*[\\p{Cntrl}\uFFFD&&[^\\t]].*";

    @TempDir
    private Path folder;

    private final List<String> alarms = new CopyOnWriteArrayList<>();

    @FuzzTest
    void anyFileGivesReadableLinesAndADamagedOneIsKept(byte[] content) throws IOException {
        Path file = folder.resolve("history");
        Path copy = folder.resolve("history.damaged");
        Files.deleteIfExists(copy);
        Files.write(file, content);
        alarms.clear();

        List<String> lines = read(file);

        assertThat(lines)
                .doesNotHaveDuplicates()
                .hasSizeLessThanOrEqualTo(History.LONGEST)
                .noneMatch(line -> line.isBlank() || line.matches(UNREADABLE));
        assertThat(read(file)).isEqualTo(lines);
        assertThat(alarms).hasSize(Files.exists(copy) ? 1 : 0).allSatisfy(OneSentence::check);
        if (Files.exists(copy)) {
            assertThat(Files.readAllBytes(copy)).isEqualTo(content);
            assertThat(Files.readString(file, StandardCharsets.UTF_8).lines()).isEqualTo(lines);
        }
    }

    /** The report of a damaged file comes to the event thread before the lines. */
    private List<String> read(Path file) {
        CompletableFuture<List<String>> lines = new CompletableFuture<>();
        new HistoryFile(file, alarms::add).read(lines::complete);
        return lines.join();
    }
}
