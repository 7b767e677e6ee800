package majic.script.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SessionRecordLimitTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final Team team = new Team(TimeSource.system());

    @Test
    void aLongSessionKeepsItsFirstCommandsAndTheNumberOfTheOthers() throws IOException {
        SessionRecord record = new SessionRecord(team, 3);
        for (int number = 1; number <= 5; number++) {
            record.keep(record.command("1 move " + number, List.of(), null, null));
        }
        Path file = folder.resolve("saved.majic");
        record.save(file);
        assertThat(Files.readAllLines(file))
                .contains("1 move 3")
                .doesNotContain("1 move 4")
                .last()
                .isEqualTo("# The session was longer: 2 later commands are not kept.");
    }
}
