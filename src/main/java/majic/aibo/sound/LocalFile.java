package majic.aibo.sound;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import majic.bot.BotException;
import majic.text.IoReason;

/** A file on this computer that a command names; a relative path starts at the folder that MAJIC runs in. */
record LocalFile(String name, Path path) {
    private static final long LARGEST_MB = 64;
    private static final long MB = 1024 * 1024;

    /**
     * The file of a name, whether it is there or not.
     *
     * @throws BotException if no file can have that name
     */
    static LocalFile named(String name) {
        try {
            return new LocalFile(name, Path.of(name));
        } catch (InvalidPathException e) {
            throw new BotException(name + ": no file can have that name", e);
        }
    }

    /** Whether something of that name is there that is no folder. */
    boolean isThere() {
        return Files.exists(path) && !Files.isDirectory(path);
    }

    boolean isFolder() {
        return Files.isDirectory(path);
    }

    /**
     * All of it.
     *
     * @throws BotException if it is no plain file, is too large for a sound to be played, or cannot be read
     */
    byte[] read() {
        try {
            if (!Files.isRegularFile(path)) {
                throw new BotException(name + ": not a file with a sound in it");
            }
            long size = Files.size(path);
            if (size > LARGEST_MB * MB) {
                throw new BotException(
                        name + ": " + size / MB + " MB are too much for a sound; " + LARGEST_MB + " MB is the most");
            }
            return Files.readAllBytes(path);
        } catch (IOException e) {
            throw new BotException(name + ": cannot be read: " + IoReason.of(e), e);
        }
    }

    /**
     * Creates the file, so that no other program takes the name meanwhile.
     *
     * @throws BotException if it is there already or cannot be made
     */
    void create(byte[] content) {
        try {
            Files.write(path, content, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        } catch (FileAlreadyExistsException e) {
            throw new BotException(name + ": is there already and is not written over; choose another name", e);
        } catch (NoSuchFileException e) {
            throw new BotException(name + ": there is no such folder", e);
        } catch (IOException e) {
            throw new BotException(name + ": cannot be written: " + IoReason.of(e), e);
        }
    }

    /**
     * Gives what was created its content.
     *
     * @throws BotException if it cannot be written, as on a full disk
     */
    void replace(byte[] content) {
        try {
            Files.write(path, content);
        } catch (IOException e) {
            throw new BotException(name + ": cannot be written: " + IoReason.of(e), e);
        }
    }

    /** Takes away what was created. */
    void delete() {
        try {
            Files.deleteIfExists(path);
        } catch (IOException e) {
            throw new BotException(name + ": is empty and cannot be deleted", e);
        }
    }
}
