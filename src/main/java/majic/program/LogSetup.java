package majic.program;

import java.nio.file.Path;
import java.util.Locale;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.jspecify.annotations.Nullable;

/**
 * Chooses MAJIC's log for all loggers. The first logger initialises the logging of the JDK, which would delay the
 * window; so this creates none, and neither may what is needed for the first painting.
 */
public final class LogSetup {
    private static volatile @Nullable Choice choice;

    /** What was installed. */
    private record Choice(Path folder, Level least) {}

    private LogSetup() {}

    /**
     * Logs to this folder from the first logger on; must be called before that is created.
     *
     * @param least the least level to log, a name such as {@code INFO} or {@code DEBUG}; another text counts as
     *     {@code INFO}
     */
    public static void install(Path folderOfLog, String least) {
        choice = new Choice(folderOfLog, level(least));
        System.setProperty("java.util.logging.manager", LogFile.OpenUntilTheEnd.class.getName());
    }

    /** Adds the log to the root logger, if one was installed. */
    static void addTo(Logger root) {
        Choice installed = choice;
        if (installed != null) {
            root.setLevel(installed.least);
            root.addHandler(LogFile.in(installed.folder));
        }
    }

    private static Level level(String name) {
        return switch (name.toUpperCase(Locale.ROOT)) {
            case "TRACE" -> Level.FINER;
            case "DEBUG" -> Level.FINE;
            case "WARN", "WARNING" -> Level.WARNING;
            case "ERROR" -> Level.SEVERE;
            default -> Level.INFO;
        };
    }
}
