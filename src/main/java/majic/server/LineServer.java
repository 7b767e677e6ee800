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
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import majic.log.Line;
import majic.log.SessionListener;
import majic.script.MajicParser;
import majic.script.Session;
import org.jspecify.annotations.Nullable;

/**
 * Receives lines of MAJIC Script over sockets and sends answers in lines, for programs in Python, MATLAB and the like:
 * plain on this computer's own addresses, and encrypted for other computers. Accepts lines from a client only after its
 * token, unless it was opened without one. One thread serves all clients and blocks for none of them, so a client that
 * floods, hangs or disconnects delays neither another client nor a stop.
 */
public final class LineServer implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(LineServer.class.getName());

    /**
     * Size of the system's queue of unaccepted connections. If it is smaller, the system drops connections during a
     * flood, and the next client waits for a second.
     */
    private static final int MOST_UNACCEPTED = 1024;

    /**
     * Connections accepted before bytes are read again. It is less than the places of clients without token, so that in
     * a flood the token of a client is read before its place goes to others.
     */
    private static final int MOST_ACCEPTED_AT_ONCE = 16;

    private static final long PAUSE_AFTER_TROUBLE_NANOS = 100_000_000;

    /** Interval in ms of the checks of clients with held lines. */
    private static final long LOOK_MS = 20;

    private final ServerSocketChannel listening;
    private final Selector selector;
    private final Session session;
    private final Admission admission;
    private final @Nullable TlsHandshakes handshakes;
    private final LongSupplier nanos;
    private final SessionListener answers = this::lineWritten;
    private final ClientPlaces clients = new ClientPlaces();
    private final ByteBuffer chunk = ByteBuffer.allocate(Wire.CHUNK);
    private volatile boolean ready;
    private volatile boolean closed;

    private LineServer(
            ServerSocketChannel listening,
            Selector selector,
            Session session,
            Admission admission,
            @Nullable TlsHandshakes handshakes,
            LongSupplier nanos) {
        this.listening = listening;
        this.selector = selector;
        this.session = session;
        this.admission = admission;
        this.handshakes = handshakes;
        this.nanos = nanos;
    }

    /**
     * Starts to listen for programs on this computer. Lines other than stops wait until {@link #ready()}.
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
                    address.getHostString() + ": without TLS only this computer may command the robots; use 127.0.0.1");
        }
        return open(address, session, tokens, null, System::nanoTime);
    }

    /**
     * Starts to listen for programs on other computers, which use TLS 1.3 and send a token first. Lines other than
     * stops wait until {@link #ready()}.
     *
     * @param address an address of this computer, or the wildcard address for all; port 0 takes a free one
     * @param session the session whose team is commanded
     * @param tokens makes the token of a port, which each client has to send first
     * @param key the server's key
     * @return the server, accepting clients
     * @throws IOException if the port is taken, or the token cannot be written
     */
    public static LineServer openTls(InetSocketAddress address, Session session, TokenMaker tokens, ListenKey key)
            throws IOException {
        return open(address, session, tokens, key, System::nanoTime);
    }

    static LineServer open(
            InetSocketAddress address,
            Session session,
            @Nullable TokenMaker tokens,
            @Nullable ListenKey key,
            LongSupplier nanos)
            throws IOException {
        ServerSocketChannel socket = bind(address);
        try {
            int port = socket.socket().getLocalPort();
            Admission admission = new Admission(tokens == null ? null : tokens.token(port), nanos);
            TlsHandshakes handshakes = key == null ? null : new TlsHandshakes(key, nanos, session::alarm);
            LineServer server = new LineServer(socket, Selector.open(), session, admission, handshakes, nanos);
            server.start();
            return server;
        } catch (IOException | RuntimeException e) {
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
            throw new IOException(
                    "cannot listen at " + address.getHostString() + ":" + address.getPort() + ": " + e.getMessage(), e);
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
        return admission.token();
    }

    /** Returns whether clients have to use TLS. */
    public boolean isEncrypted() {
        return handshakes != null;
    }

    /** Returns a sentence about the certificate if it has expired or expires within 30 days; empty otherwise. */
    public Optional<String> certificateWarning() {
        return handshakes == null ? Optional.empty() : handshakes.warning();
    }

    /** Starts to carry out lines; called when the robots that were requested at the start have been added. */
    public void ready() {
        ready = true;
        selector.wakeup();
    }

    boolean isReady() {
        return ready;
    }

    Admission admission() {
        return admission;
    }

    /** Returns whether one more client can be admitted; an idle one may lose its place for that. */
    boolean makeRoom() {
        return clients.makeRoom();
    }

    /** Returns the clock of all limits. */
    LongSupplier nanos() {
        return nanos;
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
        boolean more = false;
        while (!closed) {
            try {
                await(more);
                selector.selectedKeys().forEach(this::serve);
                selector.selectedKeys().clear();
                if (handshakes != null) {
                    handshakes.runNext();
                }
                more = clients.work();
                clients.removeGone();
            } catch (IOException | RuntimeException e) {
                LOG.log(closed ? Level.DEBUG : Level.WARNING, "the line server had trouble and goes on", e);
                LockSupport.parkNanos(PAUSE_AFTER_TROUBLE_NANOS);
            }
        }
        clients.forEach(LineClient::close);
    }

    private void await(boolean more) throws IOException {
        if (more) {
            selector.selectNow();
        } else {
            selector.select(clients.isAnyWaiting() ? LOOK_MS : 0);
        }
    }

    private void serve(SelectionKey key) {
        if (key.attachment() instanceof LineClient client) {
            client.read(chunk);
        } else {
            accept();
        }
    }

    private void accept() {
        try {
            SocketChannel socket = listening.accept();
            for (int count = 1; socket != null; count++) {
                connect(socket);
                socket = count < MOST_ACCEPTED_AT_ONCE ? listening.accept() : null;
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "no client could be taken", e);
            LockSupport.parkNanos(PAUSE_AFTER_TROUBLE_NANOS);
        }
    }

    private void connect(SocketChannel socket) throws IOException {
        socket.configureBlocking(false);
        socket.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
        SelectionKey key = socket.register(selector, SelectionKey.OP_READ);
        Wire wire = handshakes == null ? new PlainWire(socket) : handshakes.begin(socket, () -> serve(key));
        MajicParser parser = isEncrypted() ? MajicParser.network(session) : MajicParser.socket(session);
        LineClient client = new LineClient(this, key, wire, socket.socket().getInetAddress(), parser);
        key.attach(client);
        clients.add(client);
    }

    /** Ends the server; its thread then closes the connections. */
    @Override
    public void close() {
        closed = true;
        session.removeListener(answers);
        try {
            listening.close();
            selector.close();
            if (token().isPresent()) {
                token().get().delete();
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the line server", e);
        }
    }
}
