package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AdjacentPartsTest {
    @TempDir
    private Path folder;

    private Path part(String begin, int number) throws IOException {
        String head = "majic-recording\t1\t" + begin + "\t" + number + "\t" + 10 * number + ".000";
        return RecordedText.write(folder.resolve(begin.hashCode() + "-" + number + RecordingFolder.ENDING), head);
    }

    private static AdjacentParts of(Path file) throws IOException {
        return AdjacentParts.of(file, RecordingHead.read(file));
    }

    @Test
    void thePartsBeforeAndAfterOneAreThoseWithTheNearestNumbers() throws Exception {
        Path second = part("2026-11-22T11:30:05Z", 2);
        Path tenth = part("2026-11-22T11:30:05Z", 10);
        Path twelfth = part("2026-11-22T11:30:05Z", 12);
        assertThat(of(second)).isEqualTo(new AdjacentParts(Optional.empty(), Optional.of(tenth)));
        assertThat(of(tenth)).isEqualTo(new AdjacentParts(Optional.of(second), Optional.of(twelfth)));
        assertThat(of(twelfth)).isEqualTo(new AdjacentParts(Optional.of(tenth), Optional.empty()));
    }

    @Test
    void otherRecordingsAndOtherFilesAreNoParts() throws Exception {
        Path first = part("2026-11-22T11:30:05Z", 1);
        part("2026-11-22T11:30:05.250Z", 2);
        Files.writeString(folder.resolve("letter" + RecordingFolder.ENDING), "Dear all");
        Files.copy(first, folder.resolve("copy.txt"));
        assertThat(of(first)).isEqualTo(new AdjacentParts(Optional.empty(), Optional.empty()));
    }
}
