package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogManager;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The log that is chosen for all loggers, on a logger in place of the root logger of the JDK. */
class LogSetupTest {
    @TempDir
    Path folder;

    private final Logger root = Logger.getAnonymousLogger();

    /** The real root logger exists before a test installs a log, so none of them reaches it. */
    @BeforeAll
    static void makeTheLoggersOfTheJdk() {
        assertThat(LogManager.getLogManager().getLogger("")).isNotNull();
    }

    private void install(String least) {
        LogSetup.install(folder, least);
        root.setUseParentHandlers(false);
        LogSetup.addTo(root);
    }

    @AfterEach
    void closeTheLog() {
        for (Handler handler : root.getHandlers()) {
            handler.close();
        }
    }

    @Test
    void linesOfTheChosenLevelAreWrittenIntoTheFolderAndLowerOnesAreNot() {
        install("DEBUG");

        root.log(Level.FINE, "a packet arrived");
        root.log(Level.FINER, "its bytes");

        assertThat(folder.resolve("majic.0.log"))
                .content()
                .contains("a packet arrived")
                .doesNotContain("its bytes");
    }

    @ParameterizedTest
    @CsvSource({
        "TRACE, FINER",
        "DEBUG, FINE",
        "debug, FINE",
        "INFO, INFO",
        "WARN, WARNING",
        "warning, WARNING",
        "ERROR, SEVERE",
        "'', INFO",
        "loud, INFO"
    })
    void theLevelsHaveTheirUsualNamesAndAnyOtherTextMeansInfo(String least, String level) {
        install(least);

        assertThat(root.getLevel()).isEqualTo(Level.parse(level));
    }

    @Test
    void installingCreatesNoFile() {
        install("INFO");

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theJdkIsToldToUseTheManagerThatKeepsTheLogOpen() {
        install("INFO");

        assertThat(System.getProperty("java.util.logging.manager")).isEqualTo(LogFile.OpenUntilTheEnd.class.getName());
    }
}
