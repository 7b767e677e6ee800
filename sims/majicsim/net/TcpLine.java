package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;

/** A line over TCP. Writes at once what the socket takes; the rest goes out when the port's selector reports room. */
final class TcpLine extends RobotLine {
    private static final System.Logger LOG = System.getLogger(TcpLine.class.getName());
    private static final int MOST_BYTES_KEPT = 1 << 20;

    private final SocketChannel channel;
    private final SelectionKey key;
    private final ArrayDeque<ByteBuffer> unsent = new ArrayDeque<>();
    private int unsentBytes;
    private volatile boolean waits;

    TcpLine(SocketChannel channel, SelectionKey key, Wiring wiring) throws IOException {
        super(
                keyOf((InetSocketAddress) channel.getLocalAddress()),
                keyOf((InetSocketAddress) channel.getRemoteAddress()),
                wiring,
                true);
        this.channel = channel;
        this.key = key;
        channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
    }

    static String keyOf(InetSocketAddress address) {
        return address.getAddress().getHostAddress() + ":" + address.getPort();
    }

    @Override
    int write(byte[] bytes) {
        if (unsentBytes + bytes.length > MOST_BYTES_KEPT || !channel.isOpen()) {
            LOG.log(Level.DEBUG, "{0} does not read; {1} bytes to it are lost", peer(), bytes.length);
            return 0;
        }
        unsent.add(ByteBuffer.wrap(bytes));
        unsentBytes += bytes.length;
        flush();
        return bytes.length;
    }

    void flush() {
        try {
            while (!unsent.isEmpty()) {
                unsentBytes -= channel.write(unsent.peek());
                if (unsent.peek().hasRemaining()) {
                    break;
                }
                unsent.remove();
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "{0} is gone: {1}", peer(), e.getMessage());
            unsent.clear();
            unsentBytes = 0;
        }
        waits = !unsent.isEmpty();
        if (waits) {
            key.selector().wakeup();
        }
    }

    @Override
    public int unsent() {
        return unsentBytes;
    }

    @Override
    boolean isFlushed() {
        return unsent.isEmpty();
    }

    @Override
    public void close() {
        super.close();
        key.selector().wakeup();
    }

    /** May be called without the lock: bytes that have to wait later wake the port's selector. */
    void setInterest(boolean reading) {
        int wanted = (reading ? SelectionKey.OP_READ : 0) | (waits ? SelectionKey.OP_WRITE : 0);
        if (key.interestOps() != wanted) {
            key.interestOps(wanted);
        }
    }

    SelectionKey key() {
        return key;
    }

    SocketChannel channel() {
        return channel;
    }

    /** Closes without the usual handshake, like a cut cable. */
    void shut(boolean abruptly) {
        try {
            if (abruptly && channel.isOpen()) {
                channel.setOption(StandardSocketOptions.SO_LINGER, 0);
            }
            channel.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing {0}: {1}", peer(), e.getMessage());
        }
    }
}
