package majic.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * Reads a file up to a given size. A named pipe, a terminal or another device is refused without being opened, since
 * opening or reading one may block forever.
 */
public final class RegularFile {
    private RegularFile() {}

    /**
     * Reads the bytes of a regular file, or of the regular file a symbolic link leads to. Blocks for as long as the
     * file system takes.
     *
     * @param file the file's path
     * @param mostBytes the most bytes to read
     * @return its bytes from the beginning
     * @throws NoSuchFileException if there is no such file
     * @throws IOException if it is a folder, a pipe or a device, or cannot be read; the message names the reason
     */
    public static byte[] read(Path file, int mostBytes) throws IOException {
        if (!Files.exists(file)) {
            throw new NoSuchFileException(file.toString());
        }
        if (Files.isDirectory(file)) {
            throw new IOException("it is a folder");
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException("it is a pipe or a device, not a regular file");
        }
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(mostBytes);
        }
    }
}
