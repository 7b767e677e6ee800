package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import com.sun.jna.Function;
import com.sun.jna.Memory;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import java.io.File;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;

/**
 * Loads jSerialComm without its side effect on SIGHUP. While its native library is loaded ({@code JNI_OnLoad}, 2.11.4),
 * it sets seven signals of the whole process to "ignore", SIGHUP among them, which otherwise ends a program whose
 * terminal was closed. Java cannot handle an ignored signal again, so the earlier action is saved and restored through
 * the C library; under {@code nohup} it is "ignore".
 */
final class SerialLibrary {
    private static final Logger LOG = System.getLogger(SerialLibrary.class.getName());

    static {
        if (File.separatorChar == '\\') {
            SerialPort.getVersion();
        } else {
            loadKeepingHangUp();
        }
    }

    private SerialLibrary() {}

    /** Returns once the library is loaded; to be called before any other use of it. */
    static void load() {}

    private static void loadKeepingHangUp() {
        HangUpAction before = null;
        try {
            before = new HangUpAction();
        } catch (LinkageError e) {
            LOG.log(Level.WARNING, "without JNA, closing the terminal does not end a program that uses a serial port");
        }
        SerialPort.getVersion();
        if (before != null) {
            before.restore();
        }
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
