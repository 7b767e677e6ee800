package majic.link;

import java.io.File;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Explains why a serial port is not or could not be opened, by a message and by the type of the cause. */
final class SerialOpenError {
    private static final String USUAL = "dialout";
    private static final Set<String> ADMINISTRATORS = Set.of("root", "wheel");
    private static final boolean UNIX = File.separatorChar == '/';

    /** ENOTTY of Linux and macOS. */
    private static final int NOT_A_TERMINAL = 25;

    /** EIO, ENXIO and ENODEV of Linux and macOS. */
    private static final Set<Integer> NO_HARDWARE = Set.of(5, 6, 19);

    private SerialOpenError() {}

    /**
     * Checks what can be found out before a port is opened.
     *
     * @param name as the user gave it
     * @param device its name in the system; on Windows not the name of a file
     * @param users finds other programs that have it open
     * @throws IOException if it cannot or must not be opened
     */
    static void check(String name, String device, PortUsers users) throws IOException {
        File file = new File(device);
        if (file.isDirectory() || file.isFile()) {
            throw notSerial(name, file.isDirectory() ? "a folder" : "a file");
        }
        if (UNIX && file.exists() && !(file.canRead() && file.canWrite())) {
            throw notAllowed(name, file.toPath());
        }
        Optional<String> user = users.of(device);
        if (user.isPresent()) {
            throw new IOException(
                    "the serial port " + name + " is open in " + user.get()
                            + ", which would take a part of the robot's answers; can that program be ended?",
                    new FileSystemException(name));
        }
    }

    /** The port is open already in this program. */
    static IOException usedHere(String name) {
        return new IOException(
                "this program uses the serial port " + name + " already; is a robot connected to it?",
                new FileSystemException(name));
    }

    /**
     * Finds the likely reason why a port did not open.
     *
     * @param name as the user gave it
     * @param device its name in the system
     * @param error the number that the system gave
     */
    static IOException of(String name, String device, int error) {
        if (UNIX && error == NOT_A_TERMINAL) {
            return notSerial(name, "another device");
        }
        if (UNIX && NO_HARDWARE.contains(error)) {
            return new IOException(
                    "the serial port " + name + " has no hardware behind it (error " + error
                            + " of the system); which port is the adapter's?",
                    new NoSuchFileException(name));
        }
        String command = UNIX ? " (\"sudo fuser -v " + device + "\" names it)" : "";
        return new IOException(
                "cannot open the serial port " + name + "; does another program use it" + command + "?",
                new FileSystemException(name));
    }

    private static IOException notSerial(String name, String what) {
        return new IOException(
                name + " is no serial port, but " + what + "; which port is the adapter's?",
                new NoSuchFileException(name));
    }

    private static IOException notAllowed(String name, Path device) {
        try {
            PosixFileAttributes attributes = Files.readAttributes(device, PosixFileAttributes.class);
            boolean groupMay = attributes
                    .permissions()
                    .containsAll(List.of(PosixFilePermission.GROUP_READ, PosixFilePermission.GROUP_WRITE));
            return notAllowed(name, attributes.group().getName(), groupMay, device);
        } catch (IOException | UnsupportedOperationException e) {
            return notAllowed(name, USUAL, true, device);
        }
    }

    /** Joining the administrators' group is not advised. */
    static IOException notAllowed(String name, String group, boolean groupMay, Path device) {
        String remedy = groupMay && !ADMINISTRATORS.contains(group)
                ? "; are you in the group " + group + " (\"sudo usermod -aG " + group + " "
                        + System.getProperty("user.name") + "\", then log in again)?"
                : ", and its group " + group + " gives no right to it; can \"sudo chgrp " + USUAL + " " + device
                        + " && sudo chmod g+rw " + device + "\" change that?";
        return new IOException(
                "you are not allowed to use the serial port " + name + remedy, new AccessDeniedException(name));
    }
}
