package majicsim.net;

import com.sun.jna.LastErrorException;
import com.sun.jna.Library;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Platform;
import java.lang.System.Logger.Level;
import java.util.Arrays;
import java.util.function.IntSupplier;

/**
 * A pseudo-terminal in raw mode. Its client side is kept open here too, so that it stays raw and usable while clients
 * open and close it. Linux and macOS.
 */
final class PseudoTerminal {
    private static final System.Logger LOG = System.getLogger(PseudoTerminal.class.getName());
    private static final int O_RDWR = 2;
    private static final int O_NOCTTY = Platform.isMac() ? 0x20000 : 0x100;
    private static final int O_NONBLOCK = Platform.isMac() ? 0x4 : 0x800;
    private static final int F_SETFL = 4;
    private static final int TCSANOW = 0;
    private static final int TERMIOS_AT_MOST_BYTES = 256;
    private static final int POLLFD_BYTES = 8;
    private static final int POLLIN = 1;
    private static final int EINTR = 4;
    private static final int EAGAIN = Platform.isMac() ? 35 : 11;

    private final CLibrary c;
    private final int master;
    private final int slave;
    private final String path;

    /** The functions of the C library that a pseudo-terminal needs; a failure comes as an exception with its errno. */
    private interface CLibrary extends Library {
        int posix_openpt(int flags) throws LastErrorException;

        int grantpt(int master) throws LastErrorException;

        int unlockpt(int master) throws LastErrorException;

        String ptsname(int master) throws LastErrorException;

        int open(String path, int flags) throws LastErrorException;

        int close(int descriptor) throws LastErrorException;

        int fcntl(int descriptor, int command, Object... flags) throws LastErrorException;

        int tcgetattr(int descriptor, Memory termios) throws LastErrorException;

        int tcsetattr(int descriptor, int when, Memory termios) throws LastErrorException;

        void cfmakeraw(Memory termios);

        int cfgetospeed(Memory termios);

        int poll(Memory descriptors, int count, int timeoutMs) throws LastErrorException;

        int read(int descriptor, byte[] into, int count) throws LastErrorException;

        int write(int descriptor, byte[] from, int count) throws LastErrorException;
    }

    private PseudoTerminal(CLibrary c, int master, int slave, String path) {
        this.c = c;
        this.master = master;
        this.slave = slave;
        this.path = path;
    }

    static PseudoTerminal open() throws LastErrorException {
        CLibrary c = Native.load("c", CLibrary.class);
        int master = c.posix_openpt(O_RDWR | O_NOCTTY);
        try {
            c.grantpt(master);
            c.unlockpt(master);
            c.fcntl(master, F_SETFL, O_RDWR | O_NONBLOCK);
            String path = c.ptsname(master);
            int slave = c.open(path, O_RDWR | O_NOCTTY | O_NONBLOCK);
            makeRaw(c, slave);
            return new PseudoTerminal(c, master, slave, path);
        } catch (LastErrorException e) {
            c.close(master);
            throw e;
        }
    }

    String path() {
        return path;
    }

    /** Waits for bytes for at most this time; returns none if none arrived. */
    byte[] read(int timeoutMs) throws LastErrorException {
        try (Memory descriptor = new Memory(POLLFD_BYTES)) {
            descriptor.setInt(0, master);
            descriptor.setShort(4, (short) POLLIN);
            descriptor.setShort(6, (short) 0);
            if (poll(descriptor, timeoutMs) <= 0 || (descriptor.getShort(6) & POLLIN) == 0) {
                return new byte[0];
            }
        }
        byte[] chunk = new byte[1024];
        return Arrays.copyOf(chunk, Math.max(0, tried(() -> c.read(master, chunk, chunk.length))));
    }

    private int poll(Memory descriptor, int timeoutMs) throws LastErrorException {
        return tried(() -> c.poll(descriptor, 1, timeoutMs));
    }

    /**
     * Returns what a call of the C library returns, or 0 if it is to be repeated: a signal to the process ends a wait
     * early, and a system may report bytes that it has not yet got (poll(2), "Bugs").
     */
    private static int tried(IntSupplier call) throws LastErrorException {
        try {
            return call.getAsInt();
        } catch (LastErrorException e) {
            if (e.getErrorCode() == EINTR || e.getErrorCode() == EAGAIN) {
                return 0;
            }
            throw e;
        }
    }

    /** Writes what there is room for; returns how many bytes that was. */
    int write(byte[] bytes) {
        try {
            return Math.max(0, c.write(master, bytes, bytes.length));
        } catch (LastErrorException e) {
            return 0;
        }
    }

    /** The speed that the client has set, in bits a second; 0 if it is not a supported one. */
    int baud() {
        try (Memory termios = new Memory(TERMIOS_AT_MOST_BYTES)) {
            c.tcgetattr(slave, termios);
            return bitsPerSecond(c.cfgetospeed(termios));
        } catch (LastErrorException e) {
            return 0;
        }
    }

    /** Some systems have codes for the speeds, others the speeds themselves. */
    private static int bitsPerSecond(int speed) {
        return switch (speed) {
            case 12 -> 4800;
            case 13 -> 9600;
            case 14 -> 19_200;
            case 15 -> 38_400;
            case 0x1001 -> 57_600;
            case 0x1002 -> 115_200;
            case 0x1003 -> 230_400;
            case 4800, 9600, 19_200, 38_400, 57_600, 115_200, 230_400 -> speed;
            default -> 0;
        };
    }

    /** Ends a wait in {@link #read} from another thread, by a byte that is not from the client. */
    void wake() {
        try {
            c.write(slave, new byte[1], 1);
        } catch (LastErrorException e) {
            LOG.log(Level.DEBUG, "{0} is full, so its reader is awake already: {1}", path, e.getMessage());
        }
    }

    void close() {
        c.close(slave);
        c.close(master);
    }

    /** The structure's layout differs between systems, so it is passed through unread. */
    private static void makeRaw(CLibrary c, int descriptor) throws LastErrorException {
        try (Memory termios = new Memory(TERMIOS_AT_MOST_BYTES)) {
            c.tcgetattr(descriptor, termios);
            c.cfmakeraw(termios);
            c.tcsetattr(descriptor, TCSANOW, termios);
        }
    }
}
