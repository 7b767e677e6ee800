package majic.aibo.liburbi;

import java.io.IOException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;

/**
 * Whether the system holds something for a socket that the library has not read: data, which it reads at once, or the
 * end of the stream, which it never does.
 */
final class UnreadData {
    private final Selector selector;

    private UnreadData(Selector selector) {
        this.selector = selector;
    }

    static UnreadData of(SocketChannel socket) throws IOException {
        Selector selector = Selector.open();
        socket.register(selector, SelectionKey.OP_READ);
        return new UnreadData(selector);
    }

    /** Looks once; false after {@link #close}. */
    synchronized boolean isThere() throws IOException {
        if (!selector.isOpen()) {
            return false;
        }
        int ready = selector.selectNow();
        selector.selectedKeys().clear();
        return ready > 0;
    }

    /** To be called before the socket is closed, which would stay open otherwise. */
    synchronized void close() throws IOException {
        selector.close();
    }
}
