package majic;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import java.util.Properties;
import majic.bot.BotException;
import majic.bot.Settings;

/** The user's settings in a properties file, read when first needed, written anew at every change. */
final class UserSettings implements Settings {
    private final Path file;
    private final Properties kept = new Properties();
    private boolean read;

    UserSettings(Path file) {
        this.file = file;
    }

    @Override
    public synchronized Optional<String> get(String key) {
        readOnce();
        return Optional.ofNullable(kept.getProperty(key));
    }

    @Override
    public synchronized void put(String key, String value) {
        readOnce();
        kept.setProperty(key, value);
        write();
    }

    private void readOnce() {
        if (read) {
            return;
        }
        read = true;
        if (Files.exists(file)) {
            try (Reader reader = Files.newBufferedReader(file)) {
                kept.load(reader);
            } catch (IOException | IllegalArgumentException e) {
                throw new BotException("cannot read the settings in " + file + ": " + e.getMessage(), e);
            }
        }
    }

    /** Writes beside the file first, so that a crash leaves the old one whole. */
    private void write() {
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        try {
            Files.createDirectories(file.getParent());
            try (Writer writer = Files.newBufferedWriter(fresh, StandardCharsets.UTF_8)) {
                kept.store(writer, "MAJIC settings");
            }
            move(fresh);
        } catch (IOException e) {
            throw new BotException("cannot write the settings to " + file + ": " + e.getMessage(), e);
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
