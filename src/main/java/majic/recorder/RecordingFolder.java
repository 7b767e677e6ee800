package majic.recorder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import majic.log.BoundedFolder;

/**
 * The folder of the recordings. Before a new file is begun, the oldest files are deleted: those older than 30 days, and
 * as many as needed to keep the folder within its limit.
 *
 * @param path the folder; made when the first file is begun
 * @param mostBytes the limit of all files together
 * @param mostBytesPerFile where a recording goes on in another file
 */
public record RecordingFolder(Path path, long mostBytes, long mostBytesPerFile) {
    /** The end of the names of recordings. */
    public static final String ENDING = ".majicrec";

    private static final long MOST_BYTES = 200_000_000;
    private static final long MOST_BYTES_PER_FILE = 15_000_000;
    private static final Duration OLDEST = Duration.ofDays(30);

    /**
     * A folder with the usual limits: 200 MB in all, 15 MB for each file.
     *
     * @param path the folder
     */
    public RecordingFolder(Path path) {
        this(path, MOST_BYTES, MOST_BYTES_PER_FILE);
    }

    /** Deletes what is too old or too much, and returns a file that does not exist yet. */
    Path next(RecordingHead head) throws IOException {
        Files.createDirectories(path);
        folder().makeRoom(mostBytesPerFile, Instant.now().minus(OLDEST));
        // Not a constant, since making it would delay the window.
        DateTimeFormatter time = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
        String stem = "majic-" + time.format(LocalDateTime.ofInstant(head.begin(), ZoneId.systemDefault()));
        Path file = path.resolve(stem + "-" + head.part() + ENDING);
        for (int again = 2; Files.exists(file); again++) {
            file = path.resolve(stem + "-" + head.part() + "-" + again + ENDING);
        }
        return file;
    }

    private BoundedFolder folder() {
        return new BoundedFolder(path, ENDING, mostBytes);
    }

    /**
     * Returns the recordings in the folder.
     *
     * @return the oldest first; empty if there is no folder
     * @throws IOException if the folder cannot be read
     */
    public List<Path> files() throws IOException {
        return folder().files();
    }

    static boolean isRecording(Path file) {
        return file.toString().endsWith(ENDING);
    }
}
