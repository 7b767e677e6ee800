package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Tag("jdk")
class SerialOpenErrorTest {
    private static final long OWN = 1;

    @TempDir
    Path folder;

    @Test
    void aFolderIsNoSerialPort() {
        assertThatThrownBy(() -> Links.of(folder.toString(), 0, 9600).open(1000))
                .hasMessage(folder + " is no serial port, but a folder; which port is the adapter's?")
                .hasCauseInstanceOf(NoSuchFileException.class);
    }

    @Test
    void aFileIsNoSerialPort() throws IOException {
        Path file = Files.createFile(folder.resolve("notes"));

        assertThatThrownBy(() -> Links.of(file.toString(), 0, 9600).open(1000))
                .hasMessage(file + " is no serial port, but a file; which port is the adapter's?");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no such device")
    void anotherDeviceIsNoSerialPort() {
        assertThatThrownBy(() -> Links.of("/dev/null", 0, 9600).open(1000))
                .hasMessage("/dev/null is no serial port, but another device; which port is the adapter's?");
    }

    @Test
    void aMissingPortIsNamed() {
        assertThatThrownBy(() -> Links.of("/dev/ttyNONE7", 0, 9600).open(1000))
                .hasMessageStartingWith("there is no serial port /dev/ttyNONE7")
                .hasMessageEndingWith("; is the adapter plugged in?")
                .hasCauseInstanceOf(NoSuchFileException.class);
    }

    /** Another device of the same name is not taken for it. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no such folders")
    void aMissingPortOfAnotherFolderIsMissing() {
        assertThatThrownBy(() -> Links.of("/dev/serial/by-id/tty", 0, 9600).open(1000))
                .hasMessageStartingWith("there is no serial port /dev/serial/by-id/tty");
    }

    @Test
    void anyOtherPortIsTakenToBeInUse() {
        assertThat(SerialOpenError.of("COM3", "COM3", 0))
                .hasCauseInstanceOf(FileSystemException.class)
                .hasMessageStartingWith("cannot open the serial port COM3; does another program use it")
                .hasMessageEndingWith("?");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the numbers are those of Unix")
    void aPortWithoutHardwareIsNamed() {
        assertThat(SerialOpenError.of("/dev/ttyS9", "/dev/ttyS9", 5))
                .hasMessage("the serial port /dev/ttyS9 has no hardware behind it (error 5 of the system);"
                        + " which port is the adapter's?");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no groups of devices")
    void aPortOfAnotherGroupNamesTheGroupAndTheCommand() {
        assertThat(SerialOpenError.notAllowed("ttyUSB0", "dialout", true, Path.of("/dev/ttyUSB0")))
                .hasCauseInstanceOf(AccessDeniedException.class)
                .hasMessage("you are not allowed to use the serial port ttyUSB0; are you in the group dialout"
                        + " (\"sudo usermod -aG dialout " + System.getProperty("user.name")
                        + "\", then log in again)?");
    }

    @Test
    void joiningTheAdministratorsIsNotAdvised() {
        assertThat(SerialOpenError.notAllowed("ttyUSB0", "root", true, Path.of("/dev/ttyUSB0")))
                .hasMessageContaining("\"sudo chgrp dialout /dev/ttyUSB0 && sudo chmod g+rw /dev/ttyUSB0\"");
    }

    @Test
    void aGroupWithoutRightsIsNotAdvised() {
        assertThat(SerialOpenError.notAllowed("ttyUSB0", "dialout", false, Path.of("/dev/ttyUSB0")))
                .hasMessageContaining("\"sudo chgrp dialout /dev/ttyUSB0 && sudo chmod g+rw /dev/ttyUSB0\"");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no such files about processes")
    void anotherProgramThatHasThePortOpenIsNamed() throws IOException {
        process(4711, "minicom", "/dev/ttyUSB0");

        assertThatThrownBy(() -> SerialOpenError.check("lefty", "/dev/ttyUSB0", new PortUsers(folder, OWN)))
                .hasCauseInstanceOf(FileSystemException.class)
                .hasMessage("the serial port lefty is open in minicom (process 4711), which would take a part of the"
                        + " robot's answers; can that program be ended?");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no such files about processes")
    void theOtherEndOfAPseudoTerminalAndThisProgramDoNotCount() throws IOException {
        Path socat = process(4711, "socat", "/dev/pts/7");
        Files.createSymbolicLink(socat.resolve("fd/4"), Path.of("/dev/ptmx"));
        Files.createDirectories(socat.resolve("fdinfo"));
        Files.writeString(socat.resolve("fdinfo/4"), "pos:\t0\ntty-index:\t7\n");
        process(OWN, "java", "/dev/pts/7");

        assertThat(new PortUsers(folder, OWN).of("/dev/pts/7")).isEmpty();
    }

    private Path process(long number, String command, String device) throws IOException {
        Path process = folder.resolve(Long.toString(number));
        Files.createDirectories(process.resolve("fd"));
        Files.writeString(process.resolve("comm"), command + "\n");
        Files.createSymbolicLink(process.resolve("fd/3"), Path.of(device));
        return process;
    }
}
