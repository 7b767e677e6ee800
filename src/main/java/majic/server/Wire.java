package majic.server;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * A connection that never blocks, plain or encrypted. The defaults are those of a connection that keeps no bytes and
 * needs no handshake. Used on the server's thread, except {@link #isOpen}.
 */
interface Wire extends Closeable {
    /** Size of the buffer that {@link #read} needs, in bytes. */
    int CHUNK = 40_000;

    /**
     * Reads what has arrived.
     *
     * @param target an empty buffer of {@link #CHUNK} bytes
     * @return the number of bytes, 0 if there are none now, -1 at the end
     */
    int read(ByteBuffer target) throws IOException;

    /** Sends as much as the system takes now; the rest remains in the buffer. */
    void write(ByteBuffer source) throws IOException;

    /** Sends what an earlier call could not send. */
    default void flush() throws IOException {}

    /** Returns whether bytes wait in the connection itself until the system takes them. */
    default boolean hasUnsent() {
        return false;
    }

    /** Returns whether answers can be sent already. */
    default boolean isReady() {
        return true;
    }

    /** Returns whether reading must pause, because something else has to happen first. */
    default boolean isBusy() {
        return false;
    }

    /** Ends the sending direction. */
    void endOutput() throws IOException;

    boolean isOpen();
}
