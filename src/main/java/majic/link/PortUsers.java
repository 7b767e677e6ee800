package majic.link;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds the other programs that have a device open, by the files of Linux about processes (proc(5)). A second program
 * that reads a serial port takes bytes away, and the system does not refuse it. Elsewhere, and for processes of other
 * users, it finds none.
 */
final class PortUsers {
    private static final Pattern PSEUDO_TERMINAL = Pattern.compile(".*/pts/(\\d+)");

    /** Linux keeps the major number of a device in bits 8 to 19. */
    private static final int MINOR_BITS = 8;

    private static final int MAJOR_MASK = 0xFFF;

    private final Path processes;
    private final long own;

    /**
     * Reads nothing yet.
     *
     * @param processes {@code /proc}
     * @param own the number of this process, which does not count
     */
    PortUsers(Path processes, long own) {
        this.processes = processes;
        this.own = own;
    }

    static PortUsers system() {
        return new PortUsers(Path.of("/proc"), ProcessHandle.current().pid());
    }

    /** Returns a program that has a serial port open, for instance {@code minicom (process 4711)}. */
    Optional<String> of(String device) {
        if (!isTerminal(Path.of(device))) {
            return Optional.empty();
        }
        try (DirectoryStream<Path> all = Files.newDirectoryStream(processes, "[0-9]*")) {
            for (Path process : all) {
                String number = process.getFileName().toString();
                if (!number.equals(Long.toString(own)) && uses(process, device)) {
                    return Optional.of(command(process) + " (process " + number + ")");
                }
            }
        } catch (IOException e) {
            return Optional.empty();
        }
        return Optional.empty();
    }

    /** Whether the driver of a device is one of those of serial ports and pseudo-terminals, as far as that is known. */
    private boolean isTerminal(Path device) {
        try {
            long number = (Long) Files.getAttribute(device, "unix:rdev");
            String major = Long.toString(number >> MINOR_BITS & MAJOR_MASK);
            return Files.readAllLines(processes.resolve("tty/drivers")).stream()
                    .map(line -> line.split("\\s+"))
                    .anyMatch(words -> words.length > 2 && words[2].equals(major));
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException e) {
            return true;
        }
    }

    /** Whether a process has the device open, and is not what the pseudo-terminal leads to. */
    private static boolean uses(Path process, String device) {
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(process.resolve("fd"))) {
            all.forEach(files::add);
        } catch (IOException e) {
            return false;
        }
        boolean open = files.stream().anyMatch(file -> target(file).equals(device));
        return open && files.stream().noneMatch(file -> isOtherEnd(file, device));
    }

    private static boolean isOtherEnd(Path file, String device) {
        Matcher number = PSEUDO_TERMINAL.matcher(device);
        if (!number.matches() || !target(file).endsWith("/ptmx")) {
            return false;
        }
        Path details = file.getParent().resolveSibling("fdinfo").resolve(file.getFileName());
        try {
            return Files.readAllLines(details).stream()
                    .anyMatch(line -> line.matches("tty-index:\\s+" + number.group(1)));
        } catch (IOException e) {
            return false;
        }
    }

    private static String target(Path file) {
        try {
            return Files.readSymbolicLink(file).toString();
        } catch (IOException e) {
            return "";
        }
    }

    private static String command(Path process) {
        try {
            return Files.readString(process.resolve("comm")).strip();
        } catch (IOException e) {
            return "another program";
        }
    }
}
