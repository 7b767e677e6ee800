package majic.link;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * A TCP connection, with Nagle's algorithm off. Built on the classic socket because interrupting a thread that uses a
 * channel closes the channel, and an act that is interrupted must not cut its robot's line.
 */
final class TcpLink implements Link {
    private final String host;
    private final int port;
    private final Counter counter = new Counter();
    private final ReentrantLock writing = new ReentrantLock();
    private volatile @Nullable Socket socket;
    private volatile String local = "";

    TcpLink(String host, int port) {
        this.host = host;
        this.port = port;
    }

    @Override
    public void open(int timeoutMs) throws IOException {
        InetSocketAddress peer = new InetSocketAddress(host, port);
        if (peer.isUnresolved()) {
            throw new IOException("there is no computer named " + host + "; check the name or use its IP address");
        }
        Socket opening = new Socket();
        try {
            opening.setTcpNoDelay(true);
            opening.connect(peer, timeoutMs);
            local = opening.getLocalAddress().getHostAddress() + ":" + opening.getLocalPort();
            counter.opened();
            socket = opening;
            Links.register(this);
        } catch (IOException e) {
            opening.close();
            throw explained(e, timeoutMs);
        }
    }

    private IOException explained(IOException e, int timeoutMs) {
        String where = host + " port " + port;
        if (e instanceof SocketTimeoutException) {
            return new IOException("no answer from " + where + " within " + timeoutMs / 1000.0 + " s", e);
        }
        if (e instanceof ConnectException) {
            return new IOException("nothing listens at " + where, e);
        }
        if (e instanceof NoRouteToHostException) {
            return new IOException("there is no way to " + host + "; check the network", e);
        }
        return new IOException("cannot connect to " + where + ": " + e.getMessage(), e);
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
        counter.ended();
        Links.unregister(this);
        return -1;
    }

    @Override
    public void write(byte[] message) throws IOException {
        writing.lock();
        try (WriteDeadline deadline = WriteDeadline.start(this)) {
            Socket open = socket;
            if (open == null) {
                throw new IOException("the connection is closed");
            }
            counter.writing(message.length);
            try {
                open.getOutputStream().write(message);
            } catch (IOException e) {
                abort();
                throw deadline.passed() ? new IOException(host + " port " + port + " takes no more data", e) : e;
            }
        } finally {
            writing.unlock();
        }
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
        synchronized (this) {
            open = socket;
            socket = null;
        }
        if (open == null) {
            return;
        }
        ended();
        try {
            if (discarding) {
                open.setSoLinger(true, 0);
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
        return counter.traffic(local, host + ":" + port);
    }
}
