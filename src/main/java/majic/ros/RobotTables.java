package majic.ros;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import majic.environment.Settings;
import majic.ros.graph.KnownRobots;

/** Reads the table of known robots: MAJIC's own and, in front of it, the user's, a file in MAJIC's own folder. */
final class RobotTables {
    /** The user's table. */
    static final String FILE = "ros-robots.txt";

    private RobotTables() {}

    /**
     * Reads both tables.
     *
     * @param settings have the folder
     * @param alarm receives a sentence if the user's table cannot be used; MAJIC's own is used then
     */
    static KnownRobots read(Settings settings, Consumer<String> alarm) {
        KnownRobots known = KnownRobots.builtIn();
        Optional<Path> file = settings.folder().map(folder -> folder.resolve(FILE));
        if (file.isEmpty()) {
            return known;
        }
        try {
            return known.with(FILE, Files.readString(file.get()));
        } catch (NoSuchFileException e) {
            return known;
        } catch (IOException e) {
            alarm.accept("the table of robots " + file.get() + " cannot be read: " + e.getMessage());
        } catch (IllegalArgumentException e) {
            alarm.accept("the table of robots is not used: " + e.getMessage());
        }
        return known;
    }
}
