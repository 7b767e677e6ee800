package majic.link;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.Set;

/** Why the system does not open a serial port, in a sentence for the person. */
final class SerialRefusal {
    private static final String USUAL = "dialout";
    private static final Set<String> ADMINISTRATORS = Set.of("root", "wheel");

    private SerialRefusal() {}

    /**
     * Looks at a port that did not open.
     *
     * @param name as the user gave it
     * @param device what the system knows it by; on Windows no file's name
     */
    static String of(String name, File device) {
        if (device.isDirectory() || device.isFile()) {
            return name + " is no serial port; which one is the adapter's?";
        }
        if (device.exists() && !(device.canRead() && device.canWrite())) {
            String group = group(device);
            return "you are not allowed to use the serial port " + name + "; are you in the group " + group
                    + " (\"sudo usermod -aG " + group + " " + System.getProperty("user.name")
                    + "\", then log in again)?";
        }
        return "cannot open the serial port " + name + "; does another program use it?";
    }

    /** The administrators' own group is not for anybody to join. */
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
