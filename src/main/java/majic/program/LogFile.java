package majic.program;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.logging.ErrorManager;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogManager;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import org.jspecify.annotations.Nullable;

/**
 * Writes MAJIC's own log to {@code majic.log}, which is created with the first line; at 5 MB it becomes {@code majic.1.log},
 * and up to three older files are kept. The backend is {@code java.util.logging}, because a larger library would delay
 * every start by a third. Thread-safe.
 */
public final class LogFile extends Handler implements AutoCloseable {
    private static final long MOST_BYTES = 5_000_000;
    private static final int MOST_OLD_FILES = 3;
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

    private final SimpleFormatter messages = new SimpleFormatter();
    private final Path folder;
    private final long mostBytes;
    private @Nullable Writer writer;

    LogFile(Path folder, long mostBytes) {
        this.folder = folder;
        this.mostBytes = mostBytes;
    }

    /**
     * Logs to this folder from now on; must be called before the first logger is created.
     *
     * @param level the least level to log, a name such as {@code INFO} or {@code DEBUG}; another text counts as {@code INFO}
     */
    public static void install(Path folder, String level) {
        System.setProperty("java.util.logging.manager", OpenUntilTheEnd.class.getName());
        Logger root = Logger.getLogger("");
        root.setLevel(level(level));
        root.addHandler(new LogFile(folder, MOST_BYTES));
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

    /** Leaves the log open until the program has ended; the usual manager closes it before the robots are closed. */
    public static final class OpenUntilTheEnd extends LogManager {
        @Override
        public void readConfiguration() {
            // no configuration: the only handler is installed by the program
        }

        @Override
        public void reset() {
            // the handler stays
        }
    }

    @Override
    public synchronized void publish(LogRecord line) {
        try {
            Writer out = writer();
            out.write(text(line));
            out.flush();
        } catch (IOException e) {
            reportError("majic.log cannot be written", e, ErrorManager.WRITE_FAILURE);
        }
    }

    private Writer writer() throws IOException {
        Path file = folder.resolve("majic.log");
        if (writer != null && Files.size(file) >= mostBytes) {
            writer.close();
            writer = null;
            rename(file);
        }
        if (writer == null) {
            Files.createDirectories(folder);
            writer = Files.newBufferedWriter(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        }
        return writer;
    }

    private void rename(Path file) throws IOException {
        for (int number = MOST_OLD_FILES; number > 1; number--) {
            Path newer = old(number - 1);
            if (Files.exists(newer)) {
                Files.move(newer, old(number), StandardCopyOption.REPLACE_EXISTING);
            }
        }
        Files.move(file, old(1), StandardCopyOption.REPLACE_EXISTING);
    }

    private Path old(int number) {
        return folder.resolve("majic." + number + ".log");
    }

    private String text(LogRecord line) {
        StringWriter text = new StringWriter();
        PrintWriter out = new PrintWriter(text);
        out.printf(
                "%s %-7s [%s] %s - %s%n",
                TIME.format(line.getInstant()),
                line.getLevel().getName(),
                Thread.currentThread().getName(),
                line.getLoggerName(),
                messages.formatMessage(line));
        if (line.getThrown() != null) {
            line.getThrown().printStackTrace(out);
        }
        return text.toString();
    }

    @Override
    public void flush() {
        // every line is flushed
    }

    @Override
    public synchronized void close() {
        if (writer != null) {
            try {
                writer.close();
            } catch (IOException e) {
                reportError("majic.log cannot be closed", e, ErrorManager.CLOSE_FAILURE);
            }
            writer = null;
        }
    }
}
