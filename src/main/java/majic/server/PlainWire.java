package majic.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;

/**
 * Bytes as they are, for programs on this computer.
 *
 * @param socket a connection in non-blocking mode
 */
record PlainWire(SocketChannel socket) implements Wire {
    /** Bytes of one client that are read before those of the others, so that a stop among these waits for few lines. */
    private static final int BYTES_PER_TURN = 512;

    @Override
    public int read(ByteBuffer target) throws IOException {
        return socket.read(target.limit(BYTES_PER_TURN));
    }

    @Override
    public void write(ByteBuffer source) throws IOException {
        socket.write(source);
    }

    @Override
    public void endOutput() throws IOException {
        socket.shutdownOutput();
    }

    @Override
    public boolean isOpen() {
        return socket.isOpen();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
