package majic.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the session log holds every line with its time. */
class SessionLogTest {
    private static final Clock NOON = Clock.fixed(Instant.parse("2007-09-01T12:00:00.250Z"), ZoneOffset.UTC);

    @TempDir
    Path folder;

    @Test
    void keepsLinesWithTheTimeOfDay() throws IOException {
        SessionLog log = SessionLog.in(folder.resolve("new/sessions"), NOON);
        log.write("command", "1 move 500");
        log.write("answer", "two\nlines");
        log.close();
        assertThat(Files.readAllLines(log.file().orElseThrow()))
                .containsExactly(
                        "2007-09-01 12:00:00.250 command 1 move 500", "2007-09-01 12:00:00.250 answer  two\\nlines");
    }

    @Test
    void linesBeforeTheLogIsOpenedAreWrittenToItsFile() throws IOException {
        SessionLog log = SessionLog.unopened();
        log.write("notice", "early");
        assertThat(log.file()).isEmpty();

        log.open(folder);
        log.write("notice", "late");
        log.close();

        assertThat(Files.readAllLines(log.file().orElseThrow()))
                .satisfiesExactly(
                        first -> assertThat(first).endsWith(" notice  early"),
                        second -> assertThat(second).endsWith(" notice  late"));
    }

    @Test
    void aLogThatCannotBeOpenedKeepsNothing() throws IOException {
        Path file = Files.writeString(folder.resolve("sessions"), "not a folder");
        SessionLog log = SessionLog.unopened();
        log.write("notice", "early");

        assertThatIOException().isThrownBy(() -> log.open(file));

        log.write("notice", "late");
        log.close();
        assertThat(log.file()).isEmpty();
    }

    @Test
    void aSecondSessionInTheSameSecondHasAFileOfItsOwn() throws IOException {
        try (SessionLog first = SessionLog.in(folder, NOON);
                SessionLog second = SessionLog.in(folder, NOON)) {
            assertThat(first.file()).isNotEqualTo(second.file());
        }
    }

    @Test
    void aFullDiskIsReportedOnceAndTheLogContinuesWithANewLine() throws Exception {
        Path file = folder.resolve("full.log");
        BlockingQueue<String> alarms = new LinkedBlockingQueue<>();
        SmallDisk disk = new SmallDisk(file);
        SessionLog log = SessionLog.to(disk, file, NOON);
        log.onTrouble(alarms::add);
        disk.room = 60;

        log.write("command", "1 move 500");
        log.write("answer", "1 move 500: done");
        log.write("command", "1 move 600");
        assertThat(alarms.take()).contains(file.toString(), "cannot be written (no space left on device)");
        disk.room = 1000;
        assertThat(alarms.take()).contains("is written again");
        log.write("command", "1 move 700");
        log.close();

        List<String> lines = Files.readAllLines(file);
        assertThat(alarms).isEmpty();
        assertThat(lines.get(0)).isEqualTo("2007-09-01 12:00:00.250 command 1 move 500");
        assertThat(lines.get(1)).matches("2007-09-01 12:00:00.250 notice  (1 line is|2 lines are) missing here");
        assertThat(lines.get(lines.size() - 1)).isEqualTo("2007-09-01 12:00:00.250 command 1 move 700");
        assertThat(lines).allMatch(line -> line.startsWith("2007-09-01 12:00:00.250 "));
    }

    @Test
    void aFullFileIsContinuedInAnotherOneAndNoLineIsLost() throws IOException {
        SessionLogFiles files = new SessionLogFiles(new BoundedFolder(folder, ".log", 1_000_000), "session", 200);
        SessionLog log = SessionLog.in(files, NOON);
        for (int line = 1; line <= 10; line++) {
            log.write("answer", "line " + line);
        }
        log.close();
        List<String> all = linesOf(files);
        while (all.stream().noneMatch(line -> line.endsWith("line 10"))) {
            all = linesOf(files);
        }
        assertThat(Files.readAllLines(folder.resolve("session.log")))
                .last()
                .isEqualTo("2007-09-01 12:00:00.250 notice  continued in session-2.log");
        assertThat(Files.readAllLines(folder.resolve("session-2.log")))
                .first()
                .isEqualTo("2007-09-01 12:00:00.250 notice  continued from session.log");
        assertThat(all).filteredOn(line -> line.contains(" answer ")).hasSize(10);
    }

    private static List<String> linesOf(SessionLogFiles files) throws IOException {
        List<String> all = new ArrayList<>();
        for (Path file : files.folder().files()) {
            all.addAll(Files.readAllLines(file));
        }
        return all;
    }

    @Test
    void theOldestLogsAreDeletedWhenThereIsNoRoomForAnotherFile() throws IOException {
        for (int age = 1; age <= 4; age++) {
            Path old = Files.writeString(folder.resolve("session-" + age + "-days-ago.log"), "x".repeat(100));
            Files.setLastModifiedTime(old, FileTime.from(NOON.instant().minus(Duration.ofDays(age))));
        }
        Files.writeString(folder.resolve("mine.txt"), "x".repeat(1000));
        new SessionLogFiles(new BoundedFolder(folder, ".log", 300), "session", 100).makeRoom();
        assertThat(folder.toFile().list())
                .containsExactlyInAnyOrder("session-1-days-ago.log", "session-2-days-ago.log", "mine.txt");
    }

    @Test
    void noneKeepsNothing() {
        try (SessionLog log = SessionLog.none()) {
            log.write("command", "1 move 500");
            assertThat(log.file()).isEmpty();
        }
    }

    /** A file on a full disk, which accepts only a part of what is written. */
    private static final class SmallDisk implements SeekableByteChannel {
        private final SeekableByteChannel file;
        private volatile long room;

        SmallDisk(Path path) throws IOException {
            file = Files.newByteChannel(path, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        }

        @Override
        public int write(ByteBuffer bytes) throws IOException {
            int fitting = (int) Math.min(bytes.remaining(), room - file.position());
            if (fitting <= 0) {
                throw new IOException("No space left on device");
            }
            int written = file.write(bytes.slice().limit(fitting));
            bytes.position(bytes.position() + written);
            return written;
        }

        @Override
        public int read(ByteBuffer bytes) throws IOException {
            return file.read(bytes);
        }

        @Override
        public long position() throws IOException {
            return file.position();
        }

        @Override
        public SeekableByteChannel position(long position) throws IOException {
            file.position(position);
            return this;
        }

        @Override
        public long size() throws IOException {
            return file.size();
        }

        @Override
        public SeekableByteChannel truncate(long size) throws IOException {
            file.truncate(size);
            return this;
        }

        @Override
        public boolean isOpen() {
            return file.isOpen();
        }

        @Override
        public void close() throws IOException {
            file.close();
        }
    }
}
