package majic.link;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Connects sockets to a server, with Nagle's algorithm off, within a time limit and with failures explained to the
 * user.
 */
public final class TcpConnector {
    private final String host;
    private final int port;
    private final Names names;

    /** Resolves the names of computers. */
    @FunctionalInterface
    interface Names {
        InetAddress find(String host) throws UnknownHostException;
    }

    /**
     * Makes a connector, without connecting.
     *
     * @param host the server's name or address
     * @param port its TCP port
     */
    public TcpConnector(String host, int port) {
        this(host, port, InetAddress::getByName);
    }

    TcpConnector(String host, int port, Names names) {
        this.host = host;
        this.port = port;
        this.names = names;
    }

    /**
     * Looks the computer's name up and connects a socket.
     *
     * @param socket not connected
     * @param timeoutMs how long to try at most, ms
     * @throws IOException if it cannot be connected; the message is a sentence with the reason and advice
     */
    public void connect(Socket socket, int timeoutMs) throws IOException {
        long deadlineNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMs);
        connect(socket, find(timeoutMs), deadlineNanos, timeoutMs);
    }

    /** Connects a socket until a time; the message of a failure names the whole time limit. */
    void connect(Socket socket, InetAddress computer, long deadlineNanos, int timeoutMs) throws IOException {
        try {
            socket.setTcpNoDelay(true);
            long leftMs = TimeUnit.NANOSECONDS.toMillis(deadlineNanos - System.nanoTime());
            socket.connect(new InetSocketAddress(computer, port), (int) Math.max(1, leftMs));
        } catch (IOException e) {
            throw explained(e, timeoutMs);
        }
    }

    /**
     * Looks the computer's name up.
     *
     * @throws IOException if it is not found; the message is a sentence with advice
     */
    InetAddress find(int timeoutMs) throws IOException {
        try {
            return TimedCall.call("looking up " + host, timeoutMs, () -> names.find(host));
        } catch (UnknownHostException e) {
            throw new IOException(
                    "there is no computer named " + host + "; is the name right, or does its IP address do?", e);
        } catch (TimeoutException e) {
            throw new IOException(
                    "the name " + host + " was not found within " + timeoutMs / 1000.0 + " s; use its IP address", e);
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
}
