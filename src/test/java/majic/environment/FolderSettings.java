package majic.shared.broker;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;

/**
 * Settings with a folder of files, and nothing else.
 *
 * @param path the folder
 */
record FolderSettings(Path path) implements Settings {
    /** Writes the credentials of brokers into a folder, whose file only this user can read. */
    static FolderSettings withCredentials(Path folder, String... lines) throws IOException {
        Path file = Files.write(folder.resolve(CredentialsFile.NAME), List.of(lines));
        if (Files.getFileStore(file).supportsFileAttributeView("posix")) {
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        }
        return new FolderSettings(folder);
    }

    /** Returns an environment with these settings, at the time of the system. */
    BotEnvironment environment() {
        return new BotEnvironment(TimeSource.system(), this);
    }

    @Override
    public Optional<String> get(String key) {
        return Optional.empty();
    }

    @Override
    public void put(String key, String value) {
        throw new BotException("read only");
    }

    @Override
    public SortedSet<String> keys(String prefix) {
        return new TreeSet<>();
    }

    @Override
    public Optional<Path> folder() {
        return Optional.of(path);
    }
}
