package majic.environment;

import java.nio.file.Path;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import majic.bot.BotException;
import majic.time.TimeSource;

/**
 * Settings with a folder of files, and nothing else.
 *
 * @param path the folder
 */
public record FolderSettings(Path path) implements Settings {
    /** Returns an environment with these settings, at the time of the system. */
    public BotEnvironment environment() {
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
