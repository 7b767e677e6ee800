package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LogFileTest {
    private static final int ROOMY = 100_000;

    @TempDir
    Path folder;

    @Test
    void aLineHasTimeLevelThreadAndItsValues() {
        LogFile log = new LogFile(folder, ROOMY);
        LogRecord line = new LogRecord(Level.WARNING, "robot {0} is lost");
        line.setParameters(new Object[] {"3"});
        line.setLoggerName("majic.team.Team");
        log.publish(line);
        log.close();

        assertThat(folder.resolve("majic.0.log"))
                .content()
                .matches("(?s)[-0-9]{10} [:.0-9]{12} WARNING \\[.+\\] majic\\.team\\.Team - robot 3 is lost\\R");
    }

    @Test
    void anErrorIsWrittenWithItsStack() {
        LogFile log = new LogFile(folder, ROOMY);
        LogRecord line = new LogRecord(Level.SEVERE, "failed");
        line.setThrown(new IllegalStateException("why"));
        log.publish(line);
        log.close();

        assertThat(folder.resolve("majic.0.log")).content().contains("IllegalStateException: why", "at majic.program");
    }

    @Test
    void noTextCanLookLikeALineOfTheLogOrControlATerminal() {
        String forged = "2026-01-01 00:00:00.000 SEVERE [main] forged";
        LogFile log = new LogFile(folder, ROOMY);
        LogRecord line = new LogRecord(Level.WARNING, "robot\n" + forged + "\u001b[2J");
        line.setThrown(new IllegalStateException("why\n" + forged + "\u001b[2J"));
        log.publish(line);
        log.close();

        assertThat(folder.resolve("majic.0.log"))
                .content()
                .contains("robot\\n" + forged + "\\u001b[2J")
                .contains("    " + forged + "\\u001b[2J")
                .doesNotContain("\u001b", "\n2026-01-01");
    }

    @Test
    void noFileIsMadeBeforeTheFirstLine() {
        new LogFile(folder, ROOMY).close();

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFullFileIsRenamedAndThreeOldOnesAreKept() throws Exception {
        LogFile log = new LogFile(folder, 1);
        for (int number = 1; number <= 6; number++) {
            log.publish(new LogRecord(Level.INFO, "line " + number));
        }
        log.close();

        assertThat(folder.resolve("majic.1.log")).content().contains("line 6");
        assertThat(folder.resolve("majic.3.log")).content().contains("line 4");
        try (var files = Files.list(folder)) {
            assertThat(files).hasSize(4);
        }
    }

    @Test
    void theNextStartContinuesTheFile() {
        for (String text : List.of("first", "second")) {
            LogFile log = new LogFile(folder, ROOMY);
            log.publish(new LogRecord(Level.INFO, text));
            log.close();
        }

        assertThat(folder.resolve("majic.0.log")).content().contains("first", "second");
    }

    @Test
    void aLogThatCannotBeWrittenIsReportedOnceWithoutItsStack() throws Exception {
        Path noFolder = Files.createFile(folder.resolve("file"));
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream before = System.err;
        System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            LogFile log = new LogFile(noFolder, ROOMY);
            log.publish(new LogRecord(Level.INFO, "one"));
            log.publish(new LogRecord(Level.INFO, "two"));
        } finally {
            System.setErr(before);
        }

        assertThat(printed.toString(StandardCharsets.UTF_8).lines())
                .singleElement()
                .asString()
                .startsWith("majic: its log cannot be written: ")
                .contains(noFolder.toString());
    }
}
