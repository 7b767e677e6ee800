package majic.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The session log holds every line with its time. */
@Timeout(30)
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
                        "2007-09-01 12:00:00.250 command 1 move 500", "2007-09-01 12:00:00.250 answer  two lines");
    }

    @Test
    void aSecondSessionInTheSameSecondHasAFileOfItsOwn() throws IOException {
        try (SessionLog first = SessionLog.in(folder, NOON);
                SessionLog second = SessionLog.in(folder, NOON)) {
            assertThat(first.file()).isNotEqualTo(second.file());
        }
    }

    @Test
    void noneKeepsNothing() {
        try (SessionLog log = SessionLog.none()) {
            log.write("command", "1 move 500");
            assertThat(log.file()).isEmpty();
        }
    }
}
