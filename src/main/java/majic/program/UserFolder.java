package majic.program;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/**
 * The folder of the user's data: settings, session logs, MAJIC's own log, plug-ins. The environment variable
 * {@code MAJIC_HOME} chooses another place.
 *
 * @param path the folder
 */
public record UserFolder(Path path) {
    public static UserFolder standard() {
        return new UserFolder(choose(System.getenv(), System.getProperty("os.name"), System.getProperty("user.home")));
    }

    static Path choose(Map<String, String> environment, String system, String home) {
        String chosen = environment.get("MAJIC_HOME");
        if (chosen != null && !chosen.isBlank()) {
            return Path.of(chosen);
        }
        String os = system.toLowerCase(Locale.ROOT);
        if (os.contains("win") && environment.containsKey("APPDATA")) {
            return Path.of(environment.get("APPDATA"), "MAJIC");
        }
        if (os.contains("mac")) {
            return Path.of(home, "Library", "Application Support", "MAJIC");
        }
        String data = environment.get("XDG_DATA_HOME");
        return data == null || data.isBlank() ? Path.of(home, ".local", "share", "majic") : Path.of(data, "majic");
    }

    public Path file(String name) {
        return path.resolve(name);
    }
}
