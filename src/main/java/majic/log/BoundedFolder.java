package majic.log;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import majic.text.LateLogger;

/**
 * Keeps the files of one kind in a folder within a limit, by deleting the oldest ones.
 *
 * @param path the folder; need not exist
 * @param ending the end of the names of these files; others are not touched
 * @param mostBytes the limit of all of them together
 */
public record BoundedFolder(Path path, String ending, long mostBytes) {
    private static final Logger LOG = LateLogger.of(BoundedFolder.class);

    /**
     * Deletes the oldest files.
     *
     * @param bytes how much room is needed within the limit
     * @param oldest files that were last changed before are deleted in any case
     * @throws IOException if the folder cannot be read
     */
    public void makeRoom(long bytes, Instant oldest) throws IOException {
        List<Path> files = files();
        long present = 0;
        for (Path file : files) {
            present += Files.size(file);
        }
        for (Path file : files) {
            if (modified(file).toInstant().isBefore(oldest) || present > mostBytes - bytes) {
                present -= Files.size(file);
                delete(file);
            }
        }
    }

    private static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "an old file is in use: " + file, e);
        }
    }

    /**
     * Returns the files of this kind.
     *
     * @return the oldest first; empty if there is no folder
     * @throws IOException if the folder cannot be read
     */
    public List<Path> files() throws IOException {
        if (!Files.isDirectory(path)) {
            return List.of();
        }
        List<Path> found;
        try (Stream<Path> all = Files.list(path)) {
            found = new ArrayList<>(
                    all.filter(file -> file.toString().endsWith(ending)).toList());
        }
        found.sort(Comparator.comparing(BoundedFolder::modified).thenComparing(Path::toString));
        return found;
    }

    private static FileTime modified(Path file) {
        try {
            return Files.getLastModifiedTime(file);
        } catch (IOException e) {
            return FileTime.fromMillis(0);
        }
    }
}
