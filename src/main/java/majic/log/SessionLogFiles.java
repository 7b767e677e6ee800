package majic.log;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;

/**
 * The files of one session's log, named after the time of its beginning: the log goes on in another file when one is
 * full.
 *
 * @param folder the folder of the session logs
 * @param stem the names without ending
 * @param mostBytesPerFile where a log goes on in another file
 */
record SessionLogFiles(BoundedFolder folder, String stem, long mostBytesPerFile) {
    private static final DateTimeFormatter FILE_TIME = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
    private static final String ENDING = ".log";
    private static final long MOST_BYTES = 200_000_000;
    private static final long MOST_BYTES_PER_FILE = 15_000_000;

    /** Files of a session that begins now, with the usual limits: 200 MB in all, 15 MB for each file. */
    static SessionLogFiles of(Path directory, LocalDateTime begin) {
        BoundedFolder folder = new BoundedFolder(directory, ENDING, MOST_BYTES);
        return new SessionLogFiles(folder, "session-" + FILE_TIME.format(begin), MOST_BYTES_PER_FILE);
    }

    /** Returns the first name that no file has. */
    Path next() throws IOException {
        Path file = Files.createDirectories(folder.path()).resolve(stem + ENDING);
        for (int again = 2; Files.exists(file); again++) {
            file = folder.path().resolve(stem + "-" + again + ENDING);
        }
        return file;
    }

    static LineFile open(Path file) throws IOException {
        return new LineFile(Files.newByteChannel(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
    }

    /** Deletes the oldest logs until there is room for another file. */
    void makeRoom() throws IOException {
        folder.makeRoom(mostBytesPerFile, Instant.MIN);
    }
}
