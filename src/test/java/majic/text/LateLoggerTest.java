package majic.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogManager;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.Test;

class LateLoggerTest {
    private static final String NAME = LateLoggerTest.class.getName();

    private final List<LogRecord> lines = new ArrayList<>();
    private final Handler keeping = new Handler() {
        @Override
        public void publish(LogRecord line) {
            lines.add(line);
        }

        @Override
        public void flush() {
            // every line is kept
        }

        @Override
        public void close() {
            // nothing is open
        }
    };

    /** A class of its own, so that no other test has created its logger. */
    private static final class NeverLogged {}

    @Test
    void theLoggerIsNotCreatedBeforeALineIsLogged() {
        assertThat(LateLogger.of(NeverLogged.class).getName()).isEqualTo(NeverLogged.class.getName());

        assertThat(LogManager.getLogManager().getLogger(NeverLogged.class.getName()))
                .isNull();
    }

    @Test
    void aLineHasTheNameOfTheClassItsLevelItsValuesAndItsError() {
        Logger target = Logger.getLogger(NAME);
        target.addHandler(keeping);
        target.setUseParentHandlers(false);
        IllegalStateException error = new IllegalStateException("why");
        try {
            System.Logger log = LateLogger.of(LateLoggerTest.class);
            log.log(System.Logger.Level.WARNING, "robot {0} is lost", 3);
            log.log(System.Logger.Level.ERROR, "failed", error);
        } finally {
            target.removeHandler(keeping);
            target.setUseParentHandlers(true);
        }

        assertThat(lines).extracting(LogRecord::getLoggerName).containsExactly(NAME, NAME);
        assertThat(lines).extracting(LogRecord::getLevel).containsExactly(Level.WARNING, Level.SEVERE);
        assertThat(lines.get(0).getParameters()).containsExactly(3);
        assertThat(lines.get(1).getThrown()).isSameAs(error);
    }

    @Test
    void aLevelThatTheJdkLeavesOutIsNotLoggable() {
        Logger target = Logger.getLogger(NAME);
        target.setLevel(Level.WARNING);
        try {
            System.Logger log = LateLogger.of(LateLoggerTest.class);

            assertThat(log.isLoggable(System.Logger.Level.WARNING)).isTrue();
            assertThat(log.isLoggable(System.Logger.Level.INFO)).isFalse();
        } finally {
            target.setLevel(null);
        }
    }
}
