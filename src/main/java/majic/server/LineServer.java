package majic.server;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import majic.log.Line;
import majic.log.SessionListener;
import majic.script.MajicParser;
import majic.script.Session;
import org.jspecify.annotations.Nullable;

/**
 * Receives lines of MAJIC Script over sockets and sends answers in lines, for programs in Python, MATLAB and the like.
 * Listens on this computer's own addresses only, and accepts lines from a client only after its token, unless it was
 * opened without one. One thread serves all clients and blocks for none of them, so a client that floods, hangs or
 * disconnects delays neither another client nor a stop.
 */
public final class LineServer implements AutoCloseable {
    /** Maximum number of clients at a time. */
    static final int MOST_CLIENTS = 64;

    private static final System.Logger LOG = System.getLogger(LineServer.class.getName());

    /**
     * Size of the system's queue of unaccepted connections. If it is smaller, the system drops connections during a
     * flood, and the next client waits for a second.
     */
    private static final int MOST_UNACCEPTED = 1024;

    private static final long PAUSE_AFTER_TROUBLE_NANOS = 100_000_000;

    /** Interval in ms of the checks of clients with held lines. */
    private static final long LOOK_MS = 20;

    private final ServerSocketChannel listening;
    private final Selector selector;
    private final Session session;
    private final @Nullable ListenToken token;
    private final SessionListener answers = this::lineWritten;
    private final Set<LineClient> clients = ConcurrentHashMap.newKeySet();
    private volatile boolean ready;
    private volatile boolean closed;

    private LineServer(ServerSocketChannel listening, Selector selector, Session session, @Nullable ListenToken token) {
        this.listening = listening;
        this.selector = selector;
        this.session = session;
        this.token = token;
    }

    /**
     * Starts to listen. Lines other than stops wait until {@link #ready()}.
     *
     * @param address a loopback address; port 0 takes a free one
     * @param session the session whose team is commanded
     * @param tokens makes the token of a port, which each client has to send first; null if none is needed
     * @return the server, accepting clients
     * @throws IllegalArgumentException if the address is not a loopback address; the message says so
     * @throws IOException if the port is taken, or the token cannot be written
     */
    public static LineServer open(InetSocketAddress address, Session session, @Nullable TokenMaker tokens)
            throws IOException {
        if (address.isUnresolved() || !address.getAddress().isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    address.getHostString() + ": only this machine may command the robots; use 127.0.0.1");
        }
        ServerSocketChannel socket = bind(address);
        try {
            int port = socket.socket().getLocalPort();
            LineServer server =
                    new LineServer(socket, Selector.open(), session, tokens == null ? null : tokens.token(port));
            server.start();
            return server;
        } catch (IOException e) {
            socket.close();
            throw e;
        }
    }

    /** Creates the token of a port. */
    public interface TokenMaker {
        ListenToken token(int port) throws IOException;
    }

    private static ServerSocketChannel bind(InetSocketAddress address) throws IOException {
        ServerSocketChannel socket = ServerSocketChannel.open();
        try {
            socket.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            socket.configureBlocking(false);
            return socket.bind(address, MOST_UNACCEPTED);
        } catch (IOException e) {
            socket.close();
            throw new IOException("cannot listen at port " + address.getPort() + ": " + e.getMessage(), e);
        }
    }

    private void start() throws IOException {
        listening.register(selector, SelectionKey.OP_ACCEPT);
        session.addListener(answers);
        Thread serving = new Thread(this::serve, "line server " + port());
        serving.setDaemon(true);
        serving.start();
    }

    public int port() {
        return listening.socket().getLocalPort();
    }

    /** Returns the token that clients have to send; empty if none is needed. */
    public Optional<ListenToken> token() {
        return Optional.ofNullable(token);
    }

    /** Starts to carry out lines; called when the robots that were requested at the start have been added. */
    public void ready() {
        ready = true;
        selector.wakeup();
    }

    boolean isReady() {
        return ready;
    }

    private void lineWritten(Line line) {
        if (line.kind() != Line.Kind.COMMAND) {
            clients.forEach(client -> client.lineWritten(line));
            selector.wakeup();
        }
    }

    /** Runs a task, on any thread, once the clients have received all lines so far. */
    void afterwards(Runnable task) {
        session.afterwards(answers, () -> {
            task.run();
            selector.wakeup();
        });
    }

    private void serve() {
        while (!closed) {
            try {
                selector.select(clients.stream().anyMatch(LineClient::isWaiting) ? LOOK_MS : 0);
                selector.selectedKeys().forEach(this::serve);
                selector.selectedKeys().clear();
                clients.forEach(LineClient::work);
                clients.removeIf(LineClient::isGone);
            } catch (IOException | RuntimeException e) {
                LOG.log(closed ? Level.DEBUG : Level.WARNING, "the line server had trouble and goes on", e);
                LockSupport.parkNanos(PAUSE_AFTER_TROUBLE_NANOS);
            }
        }
    }

    private void serve(SelectionKey key) {
        if (key.attachment() instanceof LineClient client) {
            client.read();
        } else {
            accept();
        }
    }

    private void accept() {
        try {
            for (SocketChannel socket = listening.accept(); socket != null; socket = listening.accept()) {
                admit(socket);
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "no client could be taken", e);
            LockSupport.parkNanos(PAUSE_AFTER_TROUBLE_NANOS);
        }
    }

    private void admit(SocketChannel socket) throws IOException {
        clients.removeIf(LineClient::isGone);
        socket.configureBlocking(false);
        if (clients.size() >= MOST_CLIENTS && !dropOneThatEnded()) {
            try (socket) {
                String full = "MAJIC has " + MOST_CLIENTS + " clients already, which is the most; close one of them\n";
                socket.write(ByteBuffer.wrap(full.getBytes(StandardCharsets.UTF_8)));
            }
            return;
        }
        SelectionKey key = socket.register(selector, SelectionKey.OP_READ);
        LineClient client = new LineClient(this, key, MajicParser.remote(session));
        key.attach(client);
        clients.add(client);
    }

    /** Drops one client that sends no more lines and only waits for answers, to make room for one that does. */
    private boolean dropOneThatEnded() {
        Optional<LineClient> ended =
                clients.stream().filter(LineClient::hasEnded).findFirst();
        ended.ifPresent(LineClient::close);
        return ended.isPresent() && clients.remove(ended.get());
    }

    @Override
    public void close() {
        closed = true;
        session.removeListener(answers);
        try {
            listening.close();
            selector.close();
            if (token != null) {
                token.delete();
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the line server", e);
        }
        clients.forEach(LineClient::close);
    }
}
