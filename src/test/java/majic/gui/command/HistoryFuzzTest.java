package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.file.FuzzedFile;
import org.junit.jupiter.api.io.TempDir;

/**
 * Arbitrary command histories: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md).
 */
class HistoryFuzzTest {
    /** A line end, or a character that a command line cannot show. */
    private static final String UNREADABLE = ".*[\\p{Cntrl}\uFFFD&&[^\\t]].*";

    @TempDir
    private Path folder;

    @FuzzTest
    void anyFileGivesReadableLinesAndADamagedOneIsKept(byte[] content) throws IOException {
        FuzzedFile file = FuzzedFile.write(folder.resolve("history"), content);

        List<String> lines = read(file);

        assertThat(lines)
                .doesNotHaveDuplicates()
                .hasSizeLessThanOrEqualTo(History.LONGEST)
                .noneMatch(line -> line.isBlank() || line.matches(UNREADABLE));
        assertThat(read(file)).isEqualTo(lines);
        if (file.isKeptAsDamaged()) {
            assertThat(Files.readString(file.path()).lines()).isEqualTo(lines);
        }
    }

    /** The report of a damaged file comes to the event thread before the lines. */
    private static List<String> read(FuzzedFile file) {
        CompletableFuture<List<String>> lines = new CompletableFuture<>();
        new HistoryFile(file.path(), file::alarm).read(lines::complete);
        return lines.join();
    }
}
