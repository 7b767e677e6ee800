package majic.shared.broker;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import majic.environment.FolderSettings;

/** Credentials of brokers in a folder. */
final class WrittenCredentials {
    private WrittenCredentials() {}

    /** Writes them into a file that only this user can read; returns settings with this folder. */
    static FolderSettings in(Path folder, String... lines) throws IOException {
        Path file = Files.write(folder.resolve(CredentialsFile.NAME), List.of(lines));
        if (Files.getFileStore(file).supportsFileAttributeView("posix")) {
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        }
        return new FolderSettings(folder);
    }
}
