package majic.program;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.logging.ErrorManager;
import java.util.logging.FileHandler;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.LogManager;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import majic.text.IoReason;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Writes MAJIC's own log to {@code majic.0.log}, which is created with the first line; at 5 MB it becomes
 * {@code majic.1.log}, and up to three older files are kept. A log that cannot be written is reported once, in one
 * sentence. Uses {@code java.util.logging}, because a larger library would delay every start. Thread-safe.
 */
public final class LogFile extends Handler {
    private static final int MOST_BYTES = 5_000_000;
    private static final int FILES = 4;

    private final Path folder;
    private final int mostBytes;
    private @Nullable Handler file;

    LogFile(Path folder, int mostBytes) {
        this.folder = folder;
        this.mostBytes = mostBytes;
        setErrorManager(new OneSentence());
    }

    static LogFile in(Path folder) {
        return new LogFile(folder, MOST_BYTES);
    }

    @Override
    public synchronized void publish(LogRecord line) {
        try {
            if (file == null) {
                file = open();
            }
            file.publish(line);
        } catch (IOException e) {
            reportError(null, e, ErrorManager.OPEN_FAILURE);
        }
    }

    private Handler open() throws IOException {
        Files.createDirectories(folder);
        String pattern = folder.toString().replace("%", "%%") + "/majic.%g.log";
        FileHandler opened = new FileHandler(pattern, mostBytes, FILES, true);
        opened.setEncoding(StandardCharsets.UTF_8.name());
        opened.setFormatter(new OneLine());
        opened.setErrorManager(getErrorManager());
        return opened;
    }

    @Override
    public void flush() {
        // every line is flushed
    }

    @Override
    public synchronized void close() {
        if (file != null) {
            file.close();
            file = null;
        }
    }

    /**
     * The manager of all loggers, which the JDK creates with the first one. Adds the log to the root logger, and leaves
     * it open until the program has ended; the usual manager closes it before the robots are closed.
     */
    public static final class OpenUntilTheEnd extends LogManager {
        @Override
        public boolean addLogger(Logger logger) {
            boolean added = super.addLogger(logger);
            if (added && logger.getName().isEmpty()) {
                LogSetup.addTo(logger);
            }
            return added;
        }

        @Override
        public void readConfiguration() {
            // no configuration: the log is the only handler
        }

        @Override
        public void reset() {
            // the handler stays
        }
    }

    /**
     * Writes time, level, thread, logger and message in one line, and the stack of an error below it, indented. Control
     * characters are made visible, so that no text of a robot or a file can look like a line of the log.
     */
    private static final class OneLine extends Formatter {
        private final DateTimeFormatter time =
                DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

        @Override
        public String format(LogRecord line) {
            StringWriter text = new StringWriter();
            PrintWriter out = new PrintWriter(text);
            out.printf(
                    "%s %-7s [%s] %s - %s%n",
                    time.format(line.getInstant()),
                    line.getLevel().getName(),
                    VisibleText.of(Thread.currentThread().getName()),
                    line.getLoggerName(),
                    VisibleText.of(formatMessage(line)));
            if (line.getThrown() != null) {
                stack(line.getThrown()).lines().forEach(each -> out.println("    " + VisibleText.of(each)));
            }
            return text.toString();
        }

        private static String stack(Throwable thrown) {
            StringWriter text = new StringWriter();
            thrown.printStackTrace(new PrintWriter(text));
            return text.toString();
        }
    }

    /** Reports the first failure; the usual manager prints a stack. */
    private static final class OneSentence extends ErrorManager {
        private boolean reported;

        private static String reason(@Nullable Exception error) {
            if (error instanceof FileSystemException refused) {
                return refused.getFile() + ": " + IoReason.of(refused);
            }
            return error instanceof IOException broken ? IoReason.of(broken) : String.valueOf(error);
        }

        @Override
        public synchronized void error(@Nullable String message, @Nullable Exception error, int code) {
            if (!reported) {
                reported = true;
                System.err.println("majic: its log cannot be written: " + reason(error));
            }
        }
    }
}
