package majic.link;

import java.io.File;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.Set;

/** Explains why a serial port could not be opened, by a message and by the type of the cause. */
final class SerialOpenError {
    private static final String USUAL = "dialout";
    private static final Set<String> ADMINISTRATORS = Set.of("root", "wheel");

    private SerialOpenError() {}

    /**
     * Finds the likely reason.
     *
     * @param name as the user gave it
     * @param device its name in the system; on Windows not the name of a file
     */
    static IOException of(String name, File device) {
        if (device.isDirectory() || device.isFile()) {
            return new IOException(
                    name + " is no serial port; which one is the adapter's?", new NoSuchFileException(name));
        }
        if (device.exists() && !(device.canRead() && device.canWrite())) {
            String group = group(device);
            return new IOException(
                    "you are not allowed to use the serial port " + name + "; are you in the group " + group
                            + " (\"sudo usermod -aG " + group + " " + System.getProperty("user.name")
                            + "\", then log in again)?",
                    new AccessDeniedException(name));
        }
        return new IOException(
                "cannot open the serial port " + name + "; does another program use it?",
                new FileSystemException(name));
    }

    /** Joining the administrators' group is not advised. */
    private static String group(File device) {
        try {
            String group = Files.readAttributes(device.toPath(), PosixFileAttributes.class)
                    .group()
                    .getName();
            return ADMINISTRATORS.contains(group) ? USUAL : group;
        } catch (IOException | UnsupportedOperationException e) {
            return USUAL;
        }
    }
}
