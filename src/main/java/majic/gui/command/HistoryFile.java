package majic.gui.command;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Consumer;
import majic.gui.kit.EventThread;

/**
 * Keeps the typed lines from one start of the program to the next, in a file with one line of UTF-8 each, oldest first.
 * Several programs can use the same file: each line is appended under a lock. All reading and writing happens in the
 * background; if the file cannot be used, the lines are not kept.
 */
final class HistoryFile {
    private static final Logger LOG = System.getLogger(HistoryFile.class.getName());

    /** A file with more lines is shortened to the newest {@link History#LONGEST} ones when it is read. */
    private static final int MOST_LINES = 2 * History.LONGEST;

    /** A file lock does not exclude other threads of the same program. */
    private static final Object IN_THIS_PROGRAM = new Object();

    private final Path file;
    private final List<String> unwritten = new ArrayList<>();

    HistoryFile(Path file) {
        this.file = file;
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
                LOG.log(Level.TRACE, "{0}", lock);
                work.on(channel);
            } catch (IOException e) {
                LOG.log(Level.WARNING, "the command history {0} cannot be used: {1}", file, e.getMessage());
            }
        }
    }

    private static List<String> shortened(FileChannel channel) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate((int) channel.size());
        while (bytes.hasRemaining() && channel.read(bytes) >= 0) {
            continue;
        }
        List<String> all = new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8)
                .lines()
                .filter(line -> !line.isBlank())
                .toList();
        List<String> newest = newest(all);
        if (all.size() > MOST_LINES) {
            channel.truncate(0);
            append(channel, newest);
        }
        return newest;
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
        append(channel, lines);
    }

    private static void append(FileChannel channel, List<String> lines) throws IOException {
        StringBuilder text = new StringBuilder();
        lines.forEach(line -> text.append(line).append('\n'));
        ByteBuffer bytes = ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.UTF_8));
        channel.position(channel.size());
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }
}
