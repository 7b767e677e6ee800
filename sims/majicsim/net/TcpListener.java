package majicsim.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import org.jspecify.annotations.Nullable;

/**
 * The listening end of a TCP port on loopback. While it does not listen, it keeps the port's number, so that the system
 * gives that to no other program. Opened by any thread, then used by the port's thread.
 */
final class TcpListener {
    private static final int CHANGE_BOUND_MS = 1000;

    private final InetSocketAddress address;
    private final Selector selector;
    private @Nullable ServerSocketChannel server;
    private @Nullable SocketChannel reservation;

    private TcpListener(Selector selector, ServerSocketChannel server) throws IOException {
        this.selector = selector;
        this.server = server;
        this.address = (InetSocketAddress) server.getLocalAddress();
    }

    /** Listens at a port, 0 for any free one; throws {@link java.net.BindException} if it is taken. */
    static TcpListener open(int port, Selector selector) throws IOException {
        InetSocketAddress wanted = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
        return new TcpListener(selector, listen(wanted, selector));
    }

    private static ServerSocketChannel listen(InetSocketAddress address, Selector selector) throws IOException {
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.bind(address);
            server.configureBlocking(false);
            server.register(selector, SelectionKey.OP_ACCEPT);
            return server;
        } catch (IOException e) {
            server.close();
            throw e;
        }
    }

    /** The number of the port. */
    int port() {
        return address.getPort();
    }

    /** Listens from now on, or refuses clients; has no effect if it does so already. */
    synchronized void listen(boolean wanted) throws IOException {
        if (wanted && server == null) {
            release();
            server = listen(address, selector);
        } else if (!wanted && server != null) {
            endListening();
            reserve();
        }
        notifyAll();
    }

    /** Waits until it listens, or refuses clients; for a second at most. */
    synchronized void awaitListening(boolean wanted) {
        try {
            if (wanted != (server != null)) {
                wait(CHANGE_BOUND_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns the next client; null if none waits. */
    synchronized @Nullable SocketChannel accept() throws IOException {
        return server == null ? null : server.accept();
    }

    synchronized void close() throws IOException {
        release();
        endListening();
    }

    /**
     * The system ends the listening socket only when the selector has dropped its key. That selection takes a wake-up
     * which may have been meant for the next one, so it is repeated.
     */
    private void endListening() throws IOException {
        if (server != null) {
            server.close();
            server = null;
            selector.selectNow();
            selector.wakeup();
        }
    }

    /** A bound socket that does not listen: the system refuses clients at once. */
    private void reserve() throws IOException {
        SocketChannel bound = SocketChannel.open();
        reservation = bound;
        bound.setOption(StandardSocketOptions.SO_REUSEADDR, true);
        bound.bind(address);
    }

    private void release() throws IOException {
        if (reservation != null) {
            reservation.close();
            reservation = null;
        }
    }
}
