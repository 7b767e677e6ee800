package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.team.StopOrigin;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a program that joined a stopped site while it started says whose STOP is in force. */
class StopAtStartTest {
    @Test
    void aStopOfAnotherDeskThatWasLatchedBeforeThereWasAListenerIsReported(@TempDir Path folder) {
        StopOrigin stop = new StopOrigin("Anna at desk1", Instant.now());
        List<String> lines = new CopyOnWriteArrayList<>();
        try (Program program = new Program(new UserFolder(folder), null, false)) {
            program.team().stopAll(stop);
            program.session().flush();
            program.session().addListener(line -> lines.add(line.text()));

            program.announce();
            program.session().flush();

            assertThat(lines).containsExactly(stop + " is latched; \"release\" allows motion again");
        }
    }
}
