package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LogFileTest {
    private static final int ROOMY = 100_000;

    @TempDir
    Path folder;

    @Test
    void aLineHasTimeLevelThreadAndItsValues() throws Exception {
        try (LogFile log = new LogFile(folder, ROOMY)) {
            LogRecord line = new LogRecord(Level.WARNING, "robot {0} is lost");
            line.setParameters(new Object[] {"3"});
            line.setLoggerName("majic.team.Team");
            log.publish(line);
        }

        assertThat(folder.resolve("majic.log"))
                .content()
                .matches("(?s)[-0-9]{10} [:.0-9]{12} WARNING \\[.+\\] majic\\.team\\.Team - robot 3 is lost\\R");
    }

    @Test
    void anErrorIsWrittenWithItsStack() throws Exception {
        try (LogFile log = new LogFile(folder, ROOMY)) {
            LogRecord line = new LogRecord(Level.SEVERE, "failed");
            line.setThrown(new IllegalStateException("why"));
            log.publish(line);
        }

        assertThat(folder.resolve("majic.log")).content().contains("IllegalStateException: why", "at majic.program");
    }

    @Test
    void noFileIsMadeBeforeTheFirstLine() throws Exception {
        new LogFile(folder, ROOMY).close();

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFullFileIsRenamedAndThreeOldOnesAreKept() throws Exception {
        try (LogFile log = new LogFile(folder, 1)) {
            for (int number = 1; number <= 6; number++) {
                log.publish(new LogRecord(Level.INFO, "line " + number));
            }
        }

        assertThat(folder.resolve("majic.log")).content().contains("line 6");
        assertThat(folder.resolve("majic.1.log")).content().contains("line 5");
        assertThat(folder.resolve("majic.3.log")).content().contains("line 3");
        try (var files = Files.list(folder)) {
            assertThat(files).hasSize(4);
        }
    }
}
