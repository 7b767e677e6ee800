package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import com.sun.jna.Function;
import com.sun.jna.Memory;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import java.io.File;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.file.NativeFolder;
import org.jspecify.annotations.Nullable;

/**
 * Loads jSerialComm from a private folder, and without its side effect on SIGHUP. While its native library is loaded
 * ({@code JNI_OnLoad}, 2.11.4), it sets seven signals of the whole process to "ignore", SIGHUP among them, which
 * otherwise ends a program whose terminal was closed. Java cannot handle an ignored signal again, so the earlier action
 * is saved and restored through the C library; under {@code nohup} it is "ignore". Thread-safe.
 */
final class SerialLibrary {
    private static final Logger LOG = System.getLogger(SerialLibrary.class.getName());

    private static boolean loaded;

    /** Why the class of the library could not be initialised, which Java tries only once. */
    private static @Nullable LinkageError broken;

    private SerialLibrary() {}

    /**
     * Returns once the library is loaded; to be called before any other use of it.
     *
     * @throws IOException if it cannot be loaded; the message has the cause and the remedy
     */
    static synchronized void load() throws IOException {
        if (loaded) {
            return;
        }
        try {
            if (broken == null) {
                NativeFolder.load(
                        File.separatorChar == '\\' ? SerialPort::getVersion : SerialLibrary::versionKeepingHangUp);
                loaded = true;
                return;
            }
        } catch (LinkageError e) {
            broken = e;
        }
        throw new IOException(
                "serial ports cannot be used, since the native code of jSerialComm cannot be loaded: "
                        + String.valueOf(broken.getMessage())
                                .lines()
                                .findFirst()
                                .orElse("no reason is given"),
                broken);
    }

    private static String versionKeepingHangUp() {
        HangUpAction before = null;
        try {
            before = new HangUpAction();
        } catch (LinkageError e) {
            LOG.log(Level.WARNING, "without JNA, closing the terminal does not end a program that uses a serial port");
        }
        String version = SerialPort.getVersion();
        if (before != null) {
            before.restore();
        }
        return version;
    }

    /** The action of the process at SIGHUP, as at the creation of this object. */
    private static final class HangUpAction {
        private static final int SIGHUP = 1;

        /** Larger than {@code struct sigaction} on any system. */
        private static final int ROOM = 512;

        private final Function sigaction =
                NativeLibrary.getInstance(Platform.C_LIBRARY_NAME).getFunction("sigaction");
        private final Memory action = new Memory(ROOM);

        HangUpAction() {
            sigaction.invokeInt(new Object[] {SIGHUP, null, action});
        }

        void restore() {
            sigaction.invokeInt(new Object[] {SIGHUP, action, null});
        }
    }
}
