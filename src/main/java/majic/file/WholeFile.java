package majic.file;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * Replaces files as a whole: at each moment, also after a crash or on a full disk, a file has all of its old content or
 * all of its new one. The new content is written to a temporary file in the same folder, synchronised to the disk, and
 * moved over the old file. Permissions and symbolic links stay. All methods block.
 */
public final class WholeFile {
    private static final Logger LOG = System.getLogger(WholeFile.class.getName());

    private WholeFile() {}

    /** Writes the content of a file. */
    @FunctionalInterface
    public interface Content {
        /** Writes everything; the stream is buffered, and is closed by the caller. */
        void writeTo(OutputStream out) throws IOException;
    }

    /** Replaces a file by a text in UTF-8, as {@link #replace(Path, Content)} does. */
    public static void replace(Path file, String text) throws IOException {
        replace(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /** Replaces a file by bytes, as {@link #replace(Path, Content)} does. */
    public static void replace(Path file, byte[] bytes) throws IOException {
        replace(file, out -> out.write(bytes));
    }

    /**
     * Replaces a file, or creates it. A device or a pipe is written directly, since it has no content to lose.
     *
     * @param file the file, or a symbolic link to it
     * @param content writes the new content, once
     * @throws IOException if the file cannot be written, or {@code content} threw it; the old file is unchanged and no
     *     temporary file is left. Also if the folder permits no new file, although the file itself may be written
     */
    public static void replace(Path file, Content content) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            write(file, content, StandardOpenOption.WRITE);
            return;
        }
        Path target = target(file);
        if (Files.exists(target) && !Files.isWritable(target)) {
            throw new AccessDeniedException(target.toString());
        }
        Path fresh = target.resolveSibling(".saving-" + UUID.randomUUID());
        try {
            write(fresh, content, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            copyPermissions(target, fresh);
            move(fresh, target);
        } catch (IOException | RuntimeException | Error e) {
            discard(fresh);
            throw e;
        }
        synchroniseFolder(target.getParent());
    }

    /** Returns the file that is replaced; a symbolic link to a file that does not exist is replaced itself. */
    private static Path target(Path file) throws IOException {
        return Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
    }

    private static void write(Path file, Content content, StandardOpenOption... options) throws IOException {
        try (FileChannel channel = FileChannel.open(file, options)) {
            OutputStream out = new BufferedOutputStream(Channels.newOutputStream(channel));
            content.writeTo(out);
            out.flush();
            if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
                channel.force(true);
            }
        }
    }

    private static void copyPermissions(Path from, Path to) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(to, PosixFileAttributeView.class);
        if (view != null && Files.exists(from)) {
            view.setPermissions(Files.getPosixFilePermissions(from));
        }
    }

    private static void move(Path fresh, Path target) throws IOException {
        try {
            Files.move(fresh, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(fresh, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static void discard(Path fresh) {
        try {
            Files.deleteIfExists(fresh);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a temporary file is left", e);
        }
    }

    /** Makes the move last through a loss of power, where the system can; Windows cannot open a folder. */
    private static void synchroniseFolder(@Nullable Path folder) {
        if (folder == null) {
            return;
        }
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a folder cannot be synchronised", e);
        }
    }
}
