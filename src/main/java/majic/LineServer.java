package majic;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import majic.script.Session;

/**
 * Takes lines of MAJIC Script over a socket and answers in lines, for programs in Python, MATLAB and the like. It knows
 * no password, so it listens on this machine's own addresses only.
 */
final class LineServer implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(LineServer.class.getName());
    private static final long PAUSE_AFTER_TROUBLE_NANOS = 100_000_000;

    private final ServerSocket socket;
    private final Session session;
    private final Set<LineClient> clients = ConcurrentHashMap.newKeySet();

    private LineServer(ServerSocket socket, Session session) {
        this.socket = socket;
        this.session = session;
    }

    /**
     * Begins to listen.
     *
     * @param address a loopback address; port 0 takes a free one
     * @param session whose team is commanded
     * @return the server, accepting clients
     * @throws IOException if the port is taken
     */
    static LineServer open(InetSocketAddress address, Session session) throws IOException {
        if (address.isUnresolved() || !address.getAddress().isLoopbackAddress()) {
            throw new UsageException("--listen " + address.getHostString()
                    + ": only this machine may command the robots;" + " use 127.0.0.1");
        }
        ServerSocket socket = new ServerSocket();
        try {
            socket.setReuseAddress(true);
            socket.bind(address);
        } catch (IOException e) {
            socket.close();
            throw new IOException("cannot listen at port " + address.getPort() + ": " + e.getMessage(), e);
        }
        LineServer server = new LineServer(socket, session);
        Thread accepting = new Thread(server::accept, "listen " + socket.getLocalPort());
        accepting.setDaemon(true);
        accepting.start();
        return server;
    }

    int port() {
        return socket.getLocalPort();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                serve(socket.accept());
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "no client could be taken", e);
                LockSupport.parkNanos(PAUSE_AFTER_TROUBLE_NANOS);
            }
        }
    }

    private void serve(Socket connection) throws IOException {
        LineClient client = new LineClient(connection, session, clients::remove);
        clients.add(client);
        client.start();
    }

    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the listening socket", e);
        }
        clients.forEach(LineClient::close);
    }
}
