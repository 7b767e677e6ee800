package majic.server;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.AclEntry;
import java.nio.file.attribute.AclEntryPermission;
import java.nio.file.attribute.AclEntryType;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/**
 * The token that a client of the line server sends first, to show that it belongs to the user that started MAJIC: a new
 * random word at each start, in a file that only this user can read.
 *
 * @param word the token
 * @param file where it is kept while the server listens
 */
public record ListenToken(String word, Path file) {
    private static final int RANDOM_BYTES = 24;

    /**
     * Creates a token and writes its file, replacing one of an earlier start.
     *
     * @param folder the folder of the file
     * @param port the server's, which names the file
     * @return the token
     * @throws IOException if the file cannot be written, or not be kept from other users
     */
    public static ListenToken create(Path folder, int port) throws IOException {
        byte[] random = new byte[RANDOM_BYTES];
        new SecureRandom().nextBytes(random);
        String word = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        Path file = Files.createDirectories(folder).resolve("listen-" + port + ".token");
        Files.deleteIfExists(file);
        Set<StandardOpenOption> fresh = EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        try (var out = Files.newByteChannel(file, fresh, ownerOnly(file.getFileSystem()))) {
            out.write(StandardCharsets.UTF_8.encode(word + "\n"));
        }
        return new ListenToken(word, file);
    }

    /** Returns the permissions with which the file is created, so that at no time another user can open it. */
    private static FileAttribute<?> ownerOnly(FileSystem system) throws IOException {
        if (system.supportedFileAttributeViews().contains("posix")) {
            return PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"));
        }
        UserPrincipal user =
                system.getUserPrincipalLookupService().lookupPrincipalByName(System.getProperty("user.name"));
        AclEntry all = AclEntry.newBuilder()
                .setType(AclEntryType.ALLOW)
                .setPrincipal(user)
                .setPermissions(EnumSet.allOf(AclEntryPermission.class))
                .build();
        return new OwnerOnlyAcl(List.of(all));
    }

    private record OwnerOnlyAcl(List<AclEntry> value) implements FileAttribute<List<AclEntry>> {
        @Override
        public String name() {
            return "acl:acl";
        }
    }

    /** Compares in a time that does not reveal how much of the word is right. */
    boolean is(String said) {
        return MessageDigest.isEqual(word.getBytes(StandardCharsets.UTF_8), said.getBytes(StandardCharsets.UTF_8));
    }

    void delete() throws IOException {
        Files.deleteIfExists(file);
    }
}
