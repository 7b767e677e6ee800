package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("jdk")
class SerialOpenErrorTest {
    private static final File SHUT = new File("/dev/ttyUSB0") {
        private static final long serialVersionUID = 1;

        @Override
        public boolean exists() {
            return true;
        }

        @Override
        public boolean canRead() {
            return false;
        }
    };

    @Test
    void aFolderIsNoSerialPort(@TempDir Path folder) {
        assertThatThrownBy(() -> new SerialLink(folder.toString(), 9600).open(1000))
                .isInstanceOf(IOException.class)
                .hasMessage(folder + " is no serial port; which one is the adapter's?");
    }

    @Test
    void aPortOfAnotherGroupNamesTheGroup() {
        assertThat(SerialOpenError.of("ttyUSB0", SHUT))
                .hasCauseInstanceOf(AccessDeniedException.class)
                .hasMessageStartingWith(
                        "you are not allowed to use the serial port ttyUSB0; are you in the group dialout");
    }

    @Test
    void anyOtherPortIsTakenToBeInUse() {
        assertThat(SerialOpenError.of("COM3", new File("\\\\.\\COM3")))
                .hasCauseInstanceOf(FileSystemException.class)
                .hasMessage("cannot open the serial port COM3; does another program use it?");
    }
}
