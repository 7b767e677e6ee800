package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import majic.gui.WindowWait;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingWriterTest {
    private static final int FILE_BYTES = 1000;

    @TempDir
    private Path folder;

    private final BlockingQueue<String> alarms = new LinkedBlockingQueue<>();
    private final AtomicLong nanos = new AtomicLong();

    private static RecordingHead head(int part) {
        return new RecordingHead(Instant.now(), part, part);
    }

    private RecordingFolder small() {
        return new RecordingFolder(folder, 3 * FILE_BYTES, FILE_BYTES);
    }

    private void step(long seconds) {
        nanos.addAndGet(TimeUnit.SECONDS.toNanos(seconds));
    }

    private Path old(String name, int daysAgo) throws IOException {
        Path file = Files.write(folder.resolve(name + RecordingFolder.ENDING), new byte[FILE_BYTES]);
        Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(Duration.ofDays(daysAgo))));
        return file;
    }

    @Test
    void theOldestFilesMakeRoomForAnotherOne() throws Exception {
        Path oldest = old("a", 3);
        Path middle = old("b", 2);
        Path newest = old("c", 1);
        small().next(head(1));
        assertThat(oldest).doesNotExist();
        assertThat(middle).exists();
        assertThat(newest).exists();
    }

    @Test
    void filesOlderThanThirtyDaysAreDeleted() throws Exception {
        Path old = old("a", 31);
        small().next(head(1));
        assertThat(old).doesNotExist();
    }

    @Test
    void otherFilesInTheFolderStay() throws Exception {
        Path other = Files.write(folder.resolve("notes.txt"), new byte[10 * FILE_BYTES]);
        small().next(head(1));
        assertThat(other).exists();
    }

    @Test
    void aFileThatIsFullAsksForAnother() throws Exception {
        RecordingWriter writer = new RecordingWriter(small(), alarms::add, nanos::get);
        assertThat(writer.needsPart()).isTrue();
        writer.begin(head(1), "1.000\tline\tnotice\tbegun\n");
        assertThat(writer.needsPart()).isFalse();
        byte[] noise = new byte[4 * FILE_BYTES];
        new Random(1).nextBytes(noise);
        writer.write("\tpicture\t1\t" + java.util.Base64.getEncoder().encodeToString(noise) + "\n");
        writer.files();
        assertThat(writer.needsPart()).isTrue();
        writer.close();
    }

    @Test
    void whatWasWrittenIsReadableBeforeTheFileIsClosed() throws Exception {
        RecordingWriter writer = new RecordingWriter(small(), alarms::add, nanos::get);
        writer.begin(head(1), "1.000\tline\tnotice\tbegun\n");
        writer.write("2.000\tline\tnotice\tgoes on\n");
        List<Path> files = writer.files();
        assertThat(Recording.read(files.get(0)).lines())
                .extracting(RecordedLine::text)
                .containsExactly("begun", "goes on");
        writer.close();
    }

    @Test
    void linesAreReadableSoonWithoutARequest() throws Exception {
        RecordingWriter writer = new RecordingWriter(small(), alarms::add, nanos::get);
        writer.begin(head(1), "1.000\tline\tnotice\tbegun\n");
        Path file = writer.files().get(0);
        writer.write("2.000\tline\tnotice\tgoes\n");
        writer.write("3.000\tline\tnotice\ton\n");

        WindowWait.await("the lines in the file", () -> {
            step(1);
            return texts(file).equals(List.of("begun", "goes", "on"));
        });
        writer.close();
    }

    @Test
    void moreLinesThanTheDiskTakesAtOnceAreAllWritten() throws Exception {
        RecordingWriter writer = new RecordingWriter(new RecordingFolder(folder), alarms::add, nanos::get);
        writer.begin(head(1), "");
        int written = 0;
        for (int line = 0; line < 10_000; line++) {
            written += writer.write("\tline\tnotice\t" + line + "\n") ? 1 : 0;
        }
        int expected = written;

        WindowWait.await(
                "all lines that were taken",
                () -> writer.files().stream().anyMatch(file -> texts(file).size() == expected));
        assertThat(writer.dropped()).isEqualTo(10_000 - written);
        writer.close();
    }

    private static List<String> texts(Path file) {
        try {
            return Recording.read(file).lines().stream().map(RecordedLine::text).toList();
        } catch (IOException e) {
            return List.of();
        }
    }

    @Test
    void aFolderThatCannotBeWrittenIsReportedOnce() throws Exception {
        Path blocked = Files.writeString(folder.resolve("file"), "in the way");
        RecordingWriter writer =
                new RecordingWriter(new RecordingFolder(blocked.resolve("recordings")), alarms::add, nanos::get);
        writer.begin(head(1), "1.000\tline\tnotice\tbegun\n");
        writer.begin(head(2), "2.000\tline\tnotice\tagain\n");
        writer.close();
        assertThat(alarms.take()).contains("nothing is recorded").contains("make room there");
        assertThat(alarms).isEmpty();
    }

    @Test
    void anotherFileIsTriedAMinuteAfterAFailure() throws Exception {
        Path blocked = Files.writeString(folder.resolve("file"), "in the way");
        RecordingFolder later = new RecordingFolder(blocked.resolve("recordings"));
        RecordingWriter writer = new RecordingWriter(later, alarms::add, nanos::get);
        writer.begin(head(1), "1.000\tline\tnotice\tbegun\n");
        assertThat(alarms.take()).contains("nothing is recorded");
        Files.delete(blocked);

        step(59);
        writer.files();
        assertThat(writer.needsPart()).isFalse();
        step(2);
        WindowWait.await("another attempt", writer::needsPart);

        writer.begin(head(2), "62.000\tline\tnotice\tgoes on\n");
        assertThat(alarms.take()).contains("the recording goes on");
        writer.close();
    }
}
