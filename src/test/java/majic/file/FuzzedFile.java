package majic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.text.OneSentence;

/** A file of the user's folder with arbitrary content. Its reader keeps a damaged one under another name. */
public final class FuzzedFile {
    private final Path file;
    private final byte[] content;
    private final List<String> alarms = new CopyOnWriteArrayList<>();

    private FuzzedFile(Path file, byte[] content) {
        this.file = file;
        this.content = content;
    }

    /** Writes the file, and deletes what was kept of an earlier one. */
    public static FuzzedFile write(Path file, byte[] content) throws IOException {
        FuzzedFile written = new FuzzedFile(file, content);
        Files.deleteIfExists(written.kept());
        Files.write(file, content);
        return written;
    }

    private Path kept() {
        return file.resolveSibling(file.getFileName() + ".damaged");
    }

    public Path path() {
        return file;
    }

    /** Receives a sentence from the reader; callable from any thread. */
    public void alarm(String sentence) {
        alarms.add(sentence);
    }

    /**
     * Checks that a damaged file was reported once, in one sentence, and kept unchanged; and that nothing was reported
     * of another one.
     *
     * @return whether its reader found it damaged
     */
    public boolean isKeptAsDamaged() throws IOException {
        boolean damaged = Files.exists(kept());
        assertThat(alarms).hasSize(damaged ? 1 : 0).allSatisfy(OneSentence::check);
        if (damaged) {
            assertThat(kept()).hasBinaryContent(content);
        }
        return damaged;
    }
}
