package majic.gui.command;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import majic.file.DamagedFile;
import majic.gui.kit.EventThread;
import majic.text.IoReason;
import majic.text.LateLogger;
import majic.text.Texts;

/**
 * Keeps the typed lines from one start of the program to the next, in a file with one line of UTF-8 each, oldest first.
 * Several programs can use the same file: each line is appended under a lock. All reading and writing happens in the
 * background; if the file cannot be used, the lines are not kept. Of a damaged file a copy is kept, and the lines that
 * can still be read.
 */
final class HistoryFile {
    private static final Logger LOG = LateLogger.of(HistoryFile.class);
    private static final Texts TEXTS = Texts.of(HistoryFile.class);

    /** A file with more lines is shortened to the newest {@link History#LONGEST} ones when it is read. */
    private static final int MOST_LINES = 2 * History.LONGEST;

    /** 2 KB a line; of a larger file, the end is read. */
    private static final int MOST_BYTES = MOST_LINES * 2048;

    /** A file lock does not exclude other threads of the same program. */
    private static final Object IN_THIS_PROGRAM = new Object();

    private static final Pattern UNREADABLE = Pattern.compile("[\\p{Cntrl}\uFFFD&&[^\\t]]");

    private final Path file;
    private final Consumer<String> alarm;
    private final List<String> unwritten = new ArrayList<>();

    /**
     * Reads and writes nothing yet.
     *
     * @param alarm receives a sentence if the file is damaged, on the event dispatch thread
     */
    HistoryFile(Path file, Consumer<String> alarm) {
        this.file = file;
        this.alarm = alarm;
    }

    /**
     * Reads the lines in the background.
     *
     * @param use receives them, oldest first and each once, on the event dispatch thread
     */
    void read(Consumer<List<String>> use) {
        EventThread.background("reading the command history", () -> {
            List<String> lines = new ArrayList<>();
            locked(channel -> lines.addAll(shortened(channel)));
            EventThread.later(() -> use.accept(lines));
        });
    }

    /** Appends a line in the background. */
    void append(String line) {
        synchronized (unwritten) {
            unwritten.add(line);
        }
        EventThread.background("writing the command history", () -> locked(this::write));
    }

    private interface Work {
        void on(FileChannel channel) throws IOException;
    }

    private void locked(Work work) {
        synchronized (IN_THIS_PROGRAM) {
            try (FileChannel channel = FileChannel.open(
                            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
                    FileLock lock = channel.lock()) {
                if (lock.isValid()) {
                    work.on(channel);
                }
            } catch (IOException e) {
                LOG.log(Level.WARNING, "the command history {0} cannot be used: {1}", file, IoReason.of(e));
            }
        }
    }

    private List<String> shortened(FileChannel channel) throws IOException {
        byte[] bytes = newestBytes(channel);
        boolean isDamaged = DamagedFile.isDamagedText(bytes);
        List<String> all = new String(bytes, StandardCharsets.UTF_8)
                .lines()
                .filter(line -> !line.isBlank() && !UNREADABLE.matcher(line).find())
                .toList();
        List<String> newest = newest(all);
        if (isDamaged) {
            reportDamage(DamagedFile.copy(file));
        }
        if (isDamaged || all.size() > MOST_LINES || channel.size() > bytes.length) {
            replace(channel, newest);
        }
        return newest;
    }

    /** Reads the end of the file, from the beginning of a line on. */
    private static byte[] newestBytes(FileChannel channel) throws IOException {
        long skipped = Math.max(0, channel.size() - MOST_BYTES);
        channel.position(skipped);
        byte[] bytes = Channels.newInputStream(channel).readNBytes(MOST_BYTES);
        int from = 0;
        while (skipped > 0 && from < bytes.length && bytes[from] != '\n') {
            from++;
        }
        return Arrays.copyOfRange(bytes, from, bytes.length);
    }

    private void reportDamage(Path kept) {
        String text = TEXTS.get("history.damaged", file, kept);
        EventThread.later(() -> alarm.accept(text));
    }

    /**
     * Writes over the file before it is shortened: that needs no room on a full disk. The file is not exchanged for
     * another, since other programs may be waiting for its lock.
     */
    private static void replace(FileChannel channel, List<String> lines) throws IOException {
        channel.position(0);
        write(channel, lines);
        channel.truncate(channel.position());
    }

    /** The newest of the lines, each at its last place. */
    private static List<String> newest(List<String> all) {
        LinkedHashSet<String> once = new LinkedHashSet<>();
        for (String line : all) {
            once.remove(line);
            once.add(line);
        }
        List<String> lines = List.copyOf(once);
        return lines.subList(Math.max(0, lines.size() - History.LONGEST), lines.size());
    }

    private void write(FileChannel channel) throws IOException {
        List<String> lines;
        synchronized (unwritten) {
            lines = List.copyOf(unwritten);
            unwritten.clear();
        }
        channel.position(channel.size());
        write(channel, lines);
    }

    private static void write(FileChannel channel, List<String> lines) throws IOException {
        StringBuilder text = new StringBuilder();
        lines.forEach(line -> text.append(line).append('\n'));
        ByteBuffer bytes = ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }
}
