package majic.program;

import java.io.File;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.environment.Settings;
import majic.file.DamagedFile;
import majic.file.WholeFile;

/**
 * Holds the user's settings in a properties file, read at the first use, rewritten at every change. A damaged file is
 * renamed and the settings start empty; a file that cannot be read is tried again at every use, and is not written
 * until then. Both are reported. Thread-safe.
 */
final class UserSettings implements Settings {
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
    public Optional<Path> folder() {
        return Optional.ofNullable(file.getParent());
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
        Path renamed = DamagedFile.rename(file);
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

    private void write() {
        try {
            Files.createDirectories(file.getParent());
            WholeFile.replace(file, out -> {
                Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
                kept.store(writer, "MAJIC settings");
            });
        } catch (IOException e) {
            throw new BotException("cannot write the settings to " + file + ": " + reason(e), e);
        }
    }
}
