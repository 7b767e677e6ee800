package majic.log;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Path;
import java.time.Clock;
import java.time.LocalDateTime;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.text.IoReason;
import majic.text.LateLogger;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * Writes every line of the session, with the time of day, to a file that is complete at every moment. Uses its own
 * thread, so that a slow disk delays neither a robot nor the window. If the file cannot be written, as on a full disk,
 * that is reported once; lines are lost until it can be written again, and the log then continues with a line that
 * gives the number of lost lines. A long log goes on in further files, and the oldest logs are deleted. Thread-safe.
 */
public final class SessionLog implements AutoCloseable {
    private static final Logger LOG = LateLogger.of(SessionLog.class);
    private static final int MOST_UNWRITTEN = 10_000;
    private static final long CLOSE_BOUND_MS = 1000;
    private static final long RETRY_MS = 1000;
    private static final String END = "";

    /** Takes the place of a line when it is time to try again. */
    private static final String NOTHING_NEW = "\n";

    private final Supplier<Clock> clock;
    private volatile boolean keeps = true;
    private @Nullable SessionLogFiles files;
    private volatile @Nullable Path file;
    private @Nullable LineFile lines;
    private final AtomicLong missing = new AtomicLong();
    private volatile Consumer<String> alarm = text -> LOG.log(Level.WARNING, text);
    private boolean failing;
    private final BlockingQueue<String> unwritten = new LinkedBlockingQueue<>(MOST_UNWRITTEN);
    private final Thread writer = new Thread(this::writeAll, "session log");

    private SessionLog(Supplier<Clock> clock) {
        this.clock = clock;
    }

    /** Creates a log that writes to a channel. */
    static SessionLog to(SeekableByteChannel channel, Path file, Clock clock) {
        SessionLog log = new SessionLog(() -> clock);
        log.start(null, file, new LineFile(channel));
        return log;
    }

    /**
     * Creates a log of which {@link #open} makes the file. Lines that are written before are written to the file then.
     * The time of day is that of the computer's time zone, which is read when it is needed: it would delay the window.
     *
     * @return the log, without a file
     */
    public static SessionLog unopened() {
        return new SessionLog(Clock::systemDefaultZone);
    }

    /**
     * Starts a log in a directory as {@link #open} does. Its files and those of earlier sessions may have 200 MB; the
     * oldest are deleted.
     *
     * @param directory the directory of the session logs
     * @param clock the time of day
     * @return the log; its file is named after the time
     * @throws IOException if the file cannot be made
     */
    public static SessionLog in(Path directory, Clock clock) throws IOException {
        SessionLog log = new SessionLog(() -> clock);
        log.open(directory);
        return log;
    }

    static SessionLog in(SessionLogFiles files, Clock clock) throws IOException {
        SessionLog log = new SessionLog(() -> clock);
        log.open(files);
        return log;
    }

    /**
     * Makes the file of an unopened log in a directory, which is created if it is missing. To be called once.
     *
     * @param directory the directory of the session logs
     * @throws IOException if the file cannot be made; the log keeps nothing then
     */
    public void open(Path directory) throws IOException {
        open(SessionLogFiles.of(directory, LocalDateTime.now(clock.get())));
    }

    private void open(SessionLogFiles wanted) throws IOException {
        try {
            Path made = wanted.next();
            start(wanted, made, SessionLogFiles.open(made));
        } catch (IOException e) {
            keeps = false;
            unwritten.clear();
            throw e;
        }
    }

    private void start(@Nullable SessionLogFiles all, Path first, LineFile open) {
        files = all;
        file = first;
        lines = open;
        writer.setDaemon(true);
        writer.start();
    }

    /**
     * Creates a log that keeps nothing, for programs and tests without one.
     *
     * @return the log
     */
    public static SessionLog none() {
        SessionLog log = unopened();
        log.keeps = false;
        return log;
    }

    /**
     * Adds a line with the time of day. Returns at once; if the disk is thousands of lines behind, lines are lost, and
     * the log contains their number.
     *
     * @param kind what sort of line it is, in one word
     * @param text the line; line ends and control characters in it are made visible
     */
    public void write(String kind, String text) {
        if (!keeps) {
            return;
        }
        if (!unwritten.offer(stamped(kind, text))) {
            missing.incrementAndGet();
        }
    }

    /**
     * Sets a listener for when the log can no longer be written, and when it can be again. Without one, that is
     * reported to MAJIC's own log.
     *
     * @param listener receives a sentence, on the log's thread; may write to this log
     */
    public void onTrouble(Consumer<String> listener) {
        alarm = listener;
    }

    /**
     * Returns the file of the log that is written now.
     *
     * @return its file; empty if nothing is kept, or before the log is opened
     */
    public Optional<Path> file() {
        return Optional.ofNullable(file);
    }

    /** Writes the remaining lines, for one second at most, and ends the log. */
    @Override
    public void close() {
        if (file == null) {
            return;
        }
        try {
            if (unwritten.offer(END, CLOSE_BOUND_MS, TimeUnit.MILLISECONDS)) {
                writer.join(CLOSE_BOUND_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void writeAll() {
        makeRoom();
        try {
            for (String line = next(); !line.equals(END); line = next()) {
                append(line.equals(NOTHING_NEW) ? "" : line);
                continueIfFull();
            }
            append("");
            lines().close();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the session log could not be closed", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private LineFile lines() {
        return Objects.requireNonNull(lines);
    }

    private void makeRoom() {
        try {
            if (files != null) {
                files.makeRoom();
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "old session logs cannot be deleted", e);
        }
    }

    /** Goes on in another file, or if none can be made, in this one. */
    private void continueIfFull() {
        SessionLogFiles all = files;
        if (all == null || lines().size() < all.mostBytesPerFile()) {
            return;
        }
        makeRoom();
        try (LineFile full = lines()) {
            Path next = all.next();
            LineFile fresh = SessionLogFiles.open(next);
            fresh.append(stamped(
                    "notice", "continued from " + Objects.requireNonNull(file).getFileName()));
            full.append(stamped("notice", "continued in " + next.getFileName()));
            lines = fresh;
            file = next;
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the session log cannot go on in another file", e);
        }
    }

    /** Returns the next line; after a failure also a line that makes the writer try again. */
    private String next() throws InterruptedException {
        if (!failing) {
            return unwritten.take();
        }
        String line = unwritten.poll(RETRY_MS, TimeUnit.MILLISECONDS);
        return line == null ? NOTHING_NEW : line;
    }

    private void append(String line) {
        long lost = missing.get();
        String gap = lost == 0 ? "" : stamped("notice", count(lost) + " missing here");
        if (gap.isEmpty() && line.isEmpty()) {
            return;
        }
        try {
            lines().append(gap + line);
            missing.addAndGet(-lost);
            recovered(lost);
        } catch (IOException e) {
            missing.addAndGet(line.isEmpty() ? 0 : 1);
            failed(e);
        }
    }

    private static String count(long lost) {
        return lost == 1 ? "1 line is" : lost + " lines are";
    }

    private void failed(IOException problem) {
        if (!failing) {
            failing = true;
            alarm.accept("the session log " + file + " cannot be written (" + IoReason.of(problem)
                    + "); make room for it or allow writing, MAJIC goes on trying");
        }
    }

    private void recovered(long lost) {
        if (failing) {
            failing = false;
            alarm.accept("the session log is written again; " + count(lost) + " missing in it");
        }
    }

    /** Returns a line with its time and its end. */
    private String stamped(String kind, String text) {
        LocalDateTime time = LocalDateTime.now(clock.get());
        return String.format(Locale.ROOT, "%tF %<tT.%<tL %-7s %s%n", time, kind, VisibleText.of(text));
    }
}
