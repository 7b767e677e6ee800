package majic.environment;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;

/** The settings kept from one program start to the next, such as a dog's calibration. Thread-safe. */
public interface Settings {
    /**
     * Looks a setting up.
     *
     * @param key its name, for instance {@code aibo.192.168.1.20.forward}
     * @return what was kept last
     */
    Optional<String> get(String key);

    /**
     * Keeps a setting.
     *
     * @param key its name
     * @param value what to keep
     * @throws majic.bot.BotException if it could not be written; it then holds until the program ends
     */
    void put(String key, String value);

    /**
     * Lists settings.
     *
     * @param prefix the beginning of their names, such as {@code aibo.}
     * @return the names of all settings that begin so, those with an empty value included; sorted
     */
    SortedSet<String> keys(String prefix);

    /**
     * Returns the folder in which the user keeps files for the drivers, such as a table of robots.
     *
     * @return the folder, which need not exist; empty if the program keeps no files
     */
    default Optional<Path> folder() {
        return Optional.empty();
    }

    /**
     * Settings that are forgotten when the program ends.
     *
     * @return new and empty ones
     */
    static Settings inMemory() {
        Map<String, String> kept = new ConcurrentHashMap<>();
        return new Settings() {
            @Override
            public Optional<String> get(String key) {
                return Optional.ofNullable(kept.get(key));
            }

            @Override
            public void put(String key, String value) {
                kept.put(key, value);
            }

            @Override
            public SortedSet<String> keys(String prefix) {
                SortedSet<String> keys = new TreeSet<>(kept.keySet());
                keys.removeIf(key -> !key.startsWith(prefix));
                return keys;
            }
        };
    }
}
