package majic.program;

import java.io.File;
import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.lang.System.Logger.Level;
import java.nio.channels.FileChannel;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.environment.Settings;

/**
 * Holds the user's settings in a properties file, read at the first use, rewritten at every change. A damaged file is
 * renamed and the settings start empty; a file that cannot be read is tried again at every use, and is not written
 * until then. Both are reported. Thread-safe.
 */
final class UserSettings implements Settings {
    private static final System.Logger LOG = System.getLogger(UserSettings.class.getName());

    private final Path file;

    /** The file's content, with all changes since. */
    private final Properties kept = new Properties();

    /** Changes made while the file could not be read. */
    private final Properties unwritten = new Properties();

    private final List<String> unreported = new ArrayList<>();
    private Consumer<String> listener = unreported::add;
    private boolean read;
    private boolean unreadableReported;

    UserSettings(Path file) {
        this.file = file;
    }

    /**
     * Reports problems with the file, from the first use on.
     *
     * @param alarm receives a sentence, on the thread that uses the settings
     */
    synchronized void onTrouble(Consumer<String> alarm) {
        listener = alarm;
        unreported.forEach(alarm);
        unreported.clear();
    }

    @Override
    public synchronized Optional<String> get(String key) {
        try {
            readOnce();
        } catch (IOException e) {
            reportUnreadable(e);
        }
        return Optional.ofNullable(unwritten.getProperty(key, kept.getProperty(key)));
    }

    @Override
    public synchronized void put(String key, String value) {
        unwritten.setProperty(key, value);
        try {
            readOnce();
        } catch (IOException e) {
            reportUnreadable(e);
            throw new BotException(
                    "cannot write the settings to " + file + ", for what is there cannot be read: " + reason(e), e);
        }
        kept.putAll(unwritten);
        unwritten.clear();
        write();
    }

    @Override
    public synchronized SortedSet<String> keys(String prefix) {
        try {
            readOnce();
        } catch (IOException e) {
            reportUnreadable(e);
        }
        SortedSet<String> keys = new TreeSet<>(kept.stringPropertyNames());
        keys.addAll(unwritten.stringPropertyNames());
        keys.removeIf(key -> !key.startsWith(prefix));
        return keys;
    }

    /** Reads the file once; throws if it cannot be read, but not if it is damaged. */
    private void readOnce() throws IOException {
        if (read) {
            return;
        }
        Properties found = new Properties();
        if (Files.exists(file)) {
            try (Reader reader = Files.newBufferedReader(file)) {
                found.load(reader);
            } catch (CharacterCodingException | IllegalArgumentException e) {
                found.clear();
                renameDamaged();
            }
        }
        kept.putAll(found);
        read = true;
    }

    private void renameDamaged() throws IOException {
        Path renamed = file.resolveSibling(file.getFileName() + ".damaged");
        for (int again = 2; Files.exists(renamed); again++) {
            renamed = file.resolveSibling(file.getFileName() + ".damaged-" + again);
        }
        Files.move(file, renamed);
        listener.accept(
                "the settings in " + file + " were damaged; MAJIC goes on without them and has kept the file as "
                        + renamed + ": calibrations and what you agreed to are in it");
    }

    private void reportUnreadable(IOException problem) {
        if (!unreadableReported) {
            unreadableReported = true;
            listener.accept("cannot read the settings in " + file + ": " + reason(problem)
                    + "; MAJIC goes on without them, and writes none before it can read them");
        }
    }

    private static String reason(IOException problem) {
        return problem.getMessage() == null || problem.getMessage().contains(File.separator)
                ? "the system refuses it"
                : problem.getMessage();
    }

    /** Writes to a temporary file first, synchronised to the disk, so that a crash leaves the old file complete. */
    private void write() {
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        try {
            Files.createDirectories(file.getParent());
            try (Writer writer = Files.newBufferedWriter(fresh, StandardCharsets.UTF_8)) {
                kept.store(writer, "MAJIC settings");
            }
            try (FileChannel written = FileChannel.open(fresh, StandardOpenOption.WRITE)) {
                written.force(true);
            }
            move(fresh);
            synchroniseFolder();
        } catch (IOException e) {
            discard(fresh);
            throw new BotException("cannot write the settings to " + file + ": " + reason(e), e);
        }
    }

    /** Makes the move last through a loss of power, where the system can; Windows cannot open a folder. */
    private void synchroniseFolder() {
        try (FileChannel folder = FileChannel.open(file.getParent(), StandardOpenOption.READ)) {
            folder.force(true);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "the folder of the settings cannot be synchronised", e);
        }
    }

    /** A file that was not written completely, as on a full disk, only takes room. */
    private static void discard(Path fresh) {
        try {
            Files.deleteIfExists(fresh);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "half a file of settings is left", e);
        }
    }

    private void move(Path fresh) throws IOException {
        try {
            Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
