package majic.text;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.Locale;

/** Puts the system's refusal to read or write a file into words. */
public final class IoReason {
    private IoReason() {}

    /**
     * Says why a file could not be read or written.
     *
     * @param problem what the system refused
     * @return half a sentence without the file's name, to stand behind it in a message
     */
    public static String of(IOException problem) {
        if (problem instanceof NoSuchFileException) {
            return "there is no such folder or file";
        }
        if (problem instanceof AccessDeniedException) {
            return "it is not allowed";
        }
        if (problem instanceof CharacterCodingException) {
            return "it is not UTF-8 text";
        }
        if (problem instanceof FileAlreadyExistsException) {
            return "it is there already";
        }
        if (problem instanceof NotDirectoryException) {
            return "it is not a folder";
        }
        if (problem instanceof DirectoryNotEmptyException) {
            return "it is a folder with files in it";
        }
        String reason = problem instanceof FileSystemException refused ? refused.getReason() : problem.getMessage();
        return reason == null || reason.isBlank() ? "the system refuses it" : lowerCase(reason);
    }

    /** The system begins its reasons with a capital: "Is a directory". */
    private static String lowerCase(String reason) {
        return reason.substring(0, 1).toLowerCase(Locale.ROOT) + reason.substring(1);
    }
}
