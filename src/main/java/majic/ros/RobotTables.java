package majic.ros;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import majic.environment.Settings;
import majic.file.RegularFile;
import majic.ros.graph.KnownRobots;
import majic.text.IoReason;
import majic.text.VisibleText;

/** Reads the table of known robots: MAJIC's own and, in front of it, the user's, a file in MAJIC's own folder. */
final class RobotTables {
    /** The user's table. */
    static final String FILE = "ros-robots.txt";

    private static final int MOST_BYTES = 1_000_000;

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
            return known.with(FILE, text(file.get()));
        } catch (NoSuchFileException e) {
            return known;
        } catch (IOException e) {
            alarm.accept("the table of robots " + file.get() + " cannot be read: " + IoReason.of(e));
        } catch (IllegalArgumentException e) {
            alarm.accept(VisibleText.of("the table of robots is not used: " + e.getMessage()));
        }
        return known;
    }

    private static String text(Path file) throws IOException {
        byte[] bytes = RegularFile.read(file, MOST_BYTES + 1);
        if (bytes.length > MOST_BYTES) {
            throw new IOException("it is larger than " + MOST_BYTES / 1_000_000 + " MB");
        }
        return StandardCharsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(bytes))
                .toString();
    }
}
