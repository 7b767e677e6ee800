package majic.shared.broker;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import majic.bot.BotException;
import majic.text.IoReason;

/**
 * The file {@code brokers.properties} of the user's folder: for each broker {@code broker.HOST.user},
 * {@code broker.HOST.password}, {@code broker.HOST.ca}, {@code broker.HOST.key-store} and
 * {@code broker.HOST.key-store-password}. On systems with permissions for group and others it is only read if these
 * have none.
 *
 * @param file the file
 * @param entries its content
 */
record CredentialsFile(Path file, Properties entries) {
    static final String NAME = "brokers.properties";

    private static final Set<PosixFilePermission> OWNERS = EnumSet.of(
            PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE, PosixFilePermission.OWNER_EXECUTE);

    /**
     * Reads the file of a folder, if there is one.
     *
     * @throws BotException if others can read it, or it cannot be read
     */
    static Optional<CredentialsFile> find(Path folder) {
        Path file = folder.resolve(NAME);
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        Properties entries = new Properties();
        try {
            requireOwnerOnly(file);
            try (Reader in = Files.newBufferedReader(file)) {
                entries.load(in);
            }
        } catch (IOException e) {
            throw new BotException(
                    file + " cannot be read: " + IoReason.of(e) + "; is it a file that you may read?", e);
        } catch (IllegalArgumentException e) {
            throw new BotException(
                    file + " cannot be read: a backslash followed by u needs four hexadecimal digits; is every"
                            + " backslash doubled?",
                    e);
        }
        return Optional.of(new CredentialsFile(file, entries));
    }

    private static void requireOwnerOnly(Path file) throws IOException {
        if (Files.getFileStore(file).supportsFileAttributeView("posix")
                && !OWNERS.containsAll(Files.getPosixFilePermissions(file))) {
            throw new BotException(file + " contains passwords and can be read by other users of this computer; was"
                    + " it made yours alone, by chmod 600 " + file + "?");
        }
    }

    /** Returns the file that an entry names, relative to the folder of this file. */
    Optional<Path> path(String key) {
        return Optional.ofNullable(entries.getProperty(key)).map(name -> file.resolveSibling(name.strip()));
    }
}
