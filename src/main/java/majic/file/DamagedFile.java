package majic.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/**
 * Keeps a damaged file beside its place, with {@code .damaged} added to its name, and {@code .damaged-2} and so on if
 * that file exists. All methods but {@link #isDamagedText} block.
 */
public final class DamagedFile {
    private static final String ENDING = ".damaged";

    /** After a crash, a file may end with a block of zeros. */
    private static final Pattern CONTROL = Pattern.compile("[\\p{Cntrl}&&[^\\t\\r\\n]]");

    private DamagedFile() {}

    /**
     * Returns whether bytes cannot be a text that MAJIC has written.
     *
     * @return true if they are not UTF-8, or contain control characters besides tabs and line ends
     */
    public static boolean isDamagedText(byte[] bytes) {
        try {
            return CONTROL.matcher(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)))
                    .find();
        } catch (CharacterCodingException e) {
            return true;
        }
    }

    /**
     * Renames a file.
     *
     * @return its new name, in the same folder
     * @throws IOException if it cannot be renamed; it is unchanged
     */
    public static Path rename(Path file) throws IOException {
        return keep(file, other -> Files.move(file, other));
    }

    /**
     * Copies a file that stays where it is, since it is locked.
     *
     * @return the copy, in the same folder
     * @throws IOException if it cannot be copied
     */
    public static Path copy(Path file) throws IOException {
        return keep(file, other -> Files.copy(file, other));
    }

    private interface Keeping {
        /** Throws {@link FileAlreadyExistsException} if there is such a file. */
        void as(Path other) throws IOException;
    }

    private static Path keep(Path file, Keeping keeping) throws IOException {
        for (int number = 1; ; number++) {
            Path other = file.resolveSibling(file.getFileName() + ENDING + (number == 1 ? "" : "-" + number));
            try {
                keeping.as(other);
                return other;
            } catch (FileAlreadyExistsException e) {
                continue;
            }
        }
    }
}
