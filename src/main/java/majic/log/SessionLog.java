package majic.log;

import java.io.IOException;
import java.io.Writer;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Clock;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.jspecify.annotations.Nullable;

/**
 * The session log: all that was said, with the time of day, in a file that is complete at every moment. Written by a
 * thread of its own, so that a slow disk holds up neither a robot nor the window. Thread-safe.
 */
public final class SessionLog implements AutoCloseable {
    private static final Logger LOG = System.getLogger(SessionLog.class.getName());
    private static final DateTimeFormatter FILE_TIME = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
    private static final DateTimeFormatter LINE_TIME =
            DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS", Locale.ROOT);
    private static final int MOST_UNWRITTEN = 10_000;
    private static final long CLOSE_BOUND_MS = 1000;
    private static final String END = "";

    private final Clock clock;
    private final @Nullable Path file;
    private final BlockingQueue<String> unwritten = new LinkedBlockingQueue<>(MOST_UNWRITTEN);
    private final Thread writer = new Thread(this::writeAll, "session log");

    private SessionLog(Clock clock, @Nullable Path file) {
        this.clock = clock;
        this.file = file;
    }

    /**
     * Begins a log in a directory, which is made if need be.
     *
     * @param directory where session logs are kept
     * @param clock tells the time of day
     * @return the log; its file is named after the time
     * @throws IOException if the file cannot be made
     */
    public static SessionLog in(Path directory, Clock clock) throws IOException {
        Files.createDirectories(directory);
        String stem = "session-" + FILE_TIME.format(LocalDateTime.now(clock));
        Path file = directory.resolve(stem + ".log");
        for (int again = 2; Files.exists(file); again++) {
            file = directory.resolve(stem + "-" + again + ".log");
        }
        SessionLog log = new SessionLog(clock, Files.createFile(file));
        log.writer.setDaemon(true);
        log.writer.start();
        return log;
    }

    /**
     * A log that keeps nothing, for programs and tests that want none.
     *
     * @return the log
     */
    public static SessionLog none() {
        return new SessionLog(Clock.systemDefaultZone(), null);
    }

    /**
     * Adds a line with the time of day. Returns at once; when the disk is thousands of lines behind, lines get lost.
     *
     * @param kind what sort of line it is, in one word
     * @param text the line; line breaks in it are shown as blanks
     */
    public void write(String kind, String text) {
        if (file == null) {
            return;
        }
        String time = LINE_TIME.format(LocalDateTime.now(clock));
        String line = String.format(Locale.ROOT, "%s %-7s %s%n", time, kind, text.replaceAll("\\R", " "));
        if (!unwritten.offer(line)) {
            LOG.log(Level.DEBUG, "the session log is too far behind for: {0}", text);
        }
    }

    /**
     * Where the log is.
     *
     * @return its file; empty if nothing is kept
     */
    public Optional<Path> file() {
        return Optional.ofNullable(file);
    }

    /** Writes what is left, for one second at most, and ends the log. */
    @Override
    public void close() {
        if (file == null || !unwritten.offer(END)) {
            return;
        }
        try {
            writer.join(CLOSE_BOUND_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void writeAll() {
        try (Writer out = open()) {
            for (String line = unwritten.take(); !line.equals(END); line = unwritten.take()) {
                out.write(line);
                out.flush();
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the session log cannot be written any more", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private Writer open() throws IOException {
        return Files.newBufferedWriter(file().orElseThrow(), StandardOpenOption.APPEND);
    }
}
