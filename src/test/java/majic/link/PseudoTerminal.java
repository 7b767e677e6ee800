package majic.link;

import com.sun.jna.LastErrorException;
import com.sun.jna.Library;
import com.sun.jna.Native;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * A pseudo-terminal in place of an adapter with a robot: this side is the robot's, {@link #name()} the computer's port.
 */
public final class PseudoTerminal implements AutoCloseable {
    private static final int READ_WRITE = 2;
    private static final int NO_CONTROLLING_TERMINAL = 0x100;

    private static final int SPEED_BITS = 0x100F;

    private final int master;
    private final String name;

    /** The calls of the C library that are used. */
    public interface CLibrary extends Library {
        /** See posix_openpt(3). */
        int posix_openpt(int flags) throws LastErrorException;

        /** See grantpt(3). */
        int grantpt(int fd) throws LastErrorException;

        /** See unlockpt(3). */
        int unlockpt(int fd) throws LastErrorException;

        /** See ptsname_r(3). */
        int ptsname_r(int fd, byte[] buffer, long length) throws LastErrorException;

        /** See tcgetattr(3). */
        int tcgetattr(int fd, byte[] termios) throws LastErrorException;

        /** See read(2). */
        long read(int fd, byte[] buffer, long count) throws LastErrorException;

        /** See write(2). */
        long write(int fd, byte[] buffer, long count) throws LastErrorException;

        /** See close(2). */
        int close(int fd) throws LastErrorException;
    }

    private static final CLibrary C = Native.load("c", CLibrary.class);

    /** Makes a pair of ends. */
    public PseudoTerminal() {
        master = C.posix_openpt(READ_WRITE | NO_CONTROLLING_TERMINAL);
        C.grantpt(master);
        C.unlockpt(master);
        byte[] buffer = new byte[128];
        C.ptsname_r(master, buffer, buffer.length);
        name = Native.toString(buffer, StandardCharsets.US_ASCII);
    }

    /** The name of the port. */
    public String name() {
        return name;
    }

    /** The speed the computer has set its port to, as its code in Linux's termbits.h. */
    public int speedCode() {
        byte[] termios = new byte[128];
        C.tcgetattr(master, termios);
        int controlModes =
                ByteBuffer.wrap(termios).order(ByteOrder.nativeOrder()).getInt(8);
        return controlModes & SPEED_BITS;
    }

    /** Sends to the computer. */
    public void write(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        C.write(master, bytes, bytes.length);
    }

    /** Waits for what the computer sends next. */
    public String read() throws IOException {
        byte[] buffer = new byte[256];
        try {
            int count = (int) C.read(master, buffer, buffer.length);
            return new String(buffer, 0, Math.max(0, count), StandardCharsets.ISO_8859_1);
        } catch (LastErrorException e) {
            throw new IOException("the computer's side was closed", e);
        }
    }

    /** Removes the computer's port, as unplugging the adapter does. */
    @Override
    public void close() {
        C.close(master);
    }
}
