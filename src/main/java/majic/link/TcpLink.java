package majic.link;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.Socket;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * A TCP connection, with Nagle's algorithm off. Uses a classic socket because interrupting a thread that uses a channel
 * closes the channel, and interrupting an act must not close its robot's connection.
 */
final class TcpLink implements Link {
    private final String host;
    private final int port;
    private final String remote;
    private final TcpConnector connector;
    private final Layer layer;
    private final TrafficCounter counter = new TrafficCounter();
    private final ReentrantLock writing = new ReentrantLock();
    private volatile @Nullable Socket socket;
    private @Nullable Socket bare;
    private volatile String local = "";
    private boolean closed;

    TcpLink(String host, int port) {
        this(host, port, new TcpConnector(host, port));
    }

    TcpLink(String host, int port, TcpConnector connector) {
        this(host, port, connector, (connected, timeoutMs) -> connected);
    }

    /** What carries the bytes over a connected socket. */
    @FunctionalInterface
    interface Layer {
        /**
         * Prepares the transmission.
         *
         * @param connected closed by the link if this fails
         * @param timeoutMs how long to try at most, ms
         * @return the socket to read from and to write to, which may be the same
         * @throws IOException if the other end refuses it
         */
        Socket over(Socket connected, int timeoutMs) throws IOException;
    }

    TcpLink(String host, int port, TcpConnector connector, Layer layer) {
        this.host = host;
        this.port = port;
        this.remote = host + ":" + port;
        this.connector = connector;
        this.layer = layer;
    }

    @Override
    public void open(int timeoutMs) throws IOException {
        long deadlineNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMs);
        InetAddress computer = connector.find(timeoutMs);
        Socket opening = begin();
        try {
            connector.connect(opening, computer, deadlineNanos, timeoutMs);
            use(layer.over(opening, timeoutMs));
            local = opening.getLocalAddress().getHostAddress() + ":" + opening.getLocalPort();
            counter.opened();
            Links.register(this);
        } catch (IOException e) {
            abort();
            throw e;
        }
    }

    /** Creates the socket, which {@link #close} can close during the attempt. */
    private synchronized Socket begin() throws IOException {
        if (closed) {
            throw new IOException("closed while connecting");
        }
        Socket opening = new Socket();
        bare = opening;
        socket = opening;
        return opening;
    }

    private synchronized void use(Socket layered) throws IOException {
        if (closed) {
            throw new IOException("closed while connecting");
        }
        socket = layered;
    }

    @Override
    public int read(byte[] buffer) throws IOException {
        counter.readerIsBack();
        Socket open = socket;
        if (open == null) {
            return ended();
        }
        try {
            int count = open.getInputStream().read(buffer);
            if (count < 0) {
                return ended();
            }
            counter.handedOut(count);
            return count;
        } catch (IOException e) {
            ended();
            if (socket == null) {
                return -1;
            }
            throw e;
        }
    }

    private int ended() {
        counter.readerAtEnd();
        return -1;
    }

    @Override
    public void write(byte[] message) throws IOException {
        Socket open = socket;
        if (open == null) {
            throw new IOException("the connection is closed");
        }
        WriteDeadline.write(this, writing, host + " port " + port, () -> {
            counter.writing(message.length);
            open.getOutputStream().write(message);
        });
    }

    @Override
    public void close() {
        end(false);
    }

    @Override
    public void abort() {
        end(true);
    }

    private void end(boolean discarding) {
        Socket open;
        Socket below;
        synchronized (this) {
            open = socket;
            below = bare;
            socket = null;
            bare = null;
            closed = true;
        }
        if (open == null || below == null) {
            return;
        }
        counter.closed();
        Links.tidy();
        try {
            if (discarding) {
                // A layer might wait for a blocked writer in order to announce the end.
                below.setSoLinger(true, 0);
                below.close();
            }
            open.close();
        } catch (IOException e) {
            Links.LOG.log(Level.DEBUG, "closing " + address(), e);
        }
    }

    @Override
    public String address() {
        return "tcp:" + host + ":" + port;
    }

    @Override
    public Traffic traffic() {
        return counter.traffic(local, remote);
    }
}
