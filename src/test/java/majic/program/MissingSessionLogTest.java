package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that robots can be commanded where no session log can be written. */
class MissingSessionLogTest {
    @Test
    void aProgramThatCannotWriteASessionLogStartsAndReportsItOnce(@TempDir Path folder) throws IOException {
        Path sessions = Files.writeString(folder.resolve("sessions"), "not a folder");
        List<String> lines = Collections.synchronizedList(new ArrayList<>());
        try (Program program = new Program(new UserFolder(folder), null, false)) {
            program.session().addListener(line -> lines.add(line.text()));

            program.announce();
            program.announce();
            program.session().flush();

            assertThat(lines)
                    .containsExactly("no session log can be written in " + sessions
                            + ": it is there already; MAJIC goes on without one");
        }
    }
}
