package majic.aibo.liburbi;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.StandardSocketOptions;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import liburbi.UClient;
import liburbi.call.URBIEvent;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiTransport;
import majic.link.TcpConnector;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Carries the messages of one connection by liburbi-java. The library's thread only puts them into a queue, from which
 * a thread of this transport delivers them, so no receiver can delay or end the library's reading.
 *
 * <p>The library does not notice that a server has closed. On a connection without messages an empty command is
 * written, to which no server replies: each second, and every {@value #LOOK_MS} ms while there is something that the
 * library does not read. Writing to a closed connection fails at the second time at the latest.
 */
final class LiburbiTransport implements UrbiTransport {
    private static final Logger LOG = System.getLogger(LiburbiTransport.class.getName());
    private static final int LOOK_MS = 100;
    private static final int LOOKS_PER_PROBE = 10;

    /** More than a dog sends in a minute. */
    private static final int MOST_WAITING = 10_000;

    /** Put behind the last message, to wake the thread that delivers. */
    private static final UrbiMessage END = UrbiMessage.of(0, null, "");

    private static final byte[] NOTHING = ";".getBytes(StandardCharsets.US_ASCII);

    private final TcpConnector server;
    private final Clients clients;
    private final BlockingQueue<UrbiMessage> incoming = new LinkedBlockingQueue<>(MOST_WAITING);
    private final AtomicReference<@Nullable IOException> end = new AtomicReference<>();
    private volatile @Nullable SocketChannel socket;
    private volatile @Nullable UnreadData unread;
    private volatile @Nullable LiburbiWriter writer;

    /** Creates the library's clients. */
    @FunctionalInterface
    interface Clients {
        /** Creates a client on a connected socket, which passes every message to the listener. */
        UClient on(SocketChannel socket, Consumer<URBIEvent> listener);
    }

    LiburbiTransport(TcpConnector server, Clients clients) {
        this.server = server;
        this.clients = clients;
    }

    @Override
    public void open(int timeoutMs, String name, Receiver receiver) throws IOException {
        SocketChannel opening = SocketChannel.open();
        socket = opening;
        try {
            failIfEnded();
            server.connect(opening.socket(), timeoutMs);
            opening.configureBlocking(false);
            unread = UnreadData.of(opening);
            writer = LiburbiWriter.start(name, () -> clients.on(opening, this::take), this::end);
            failIfEnded();
        } catch (IOException e) {
            if (!end(e, true)) {
                closeWriter();
            }
            throw e;
        }
        Thread reader = new Thread(() -> WaitPolicy.without(() -> deliver(receiver)), name + " reader");
        reader.setDaemon(true);
        reader.start();
    }

    /** Closes what was created while another thread ended the connection. */
    private void closeWriter() {
        LiburbiWriter created = writer;
        if (created != null) {
            created.close();
        }
    }

    private void failIfEnded() throws IOException {
        IOException cause = end.get();
        if (cause != null) {
            throw new IOException("closed while connecting", cause);
        }
    }

    /** Takes an event on the library's thread, which would end if this threw. */
    private void take(URBIEvent event) {
        try {
            if (!incoming.offer(LiburbiEvents.message(event))) {
                end(new IOException("more messages came in than could be handled"));
            }
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "could not take in a message of liburbi-java", e);
        }
    }

    private void deliver(Receiver receiver) {
        for (UrbiMessage message = next(); message != END; message = next()) {
            deliver(message, receiver);
        }
        receiver.ended(cause());
    }

    private static void deliver(UrbiMessage message, Receiver receiver) {
        try {
            receiver.received(message);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "could not take in " + message, e);
        }
    }

    /** Waits for a message, and writes where none comes; returns {@link #END} at the end. */
    private UrbiMessage next() {
        for (int looks = 1; ; looks++) {
            UrbiMessage message = poll();
            if (message != null) {
                return message;
            }
            if (end.get() != null) {
                return END;
            }
            if (looks % LOOKS_PER_PROBE == 0 || isUnread()) {
                probe();
            }
        }
    }

    private @Nullable UrbiMessage poll() {
        try {
            return incoming.poll(LOOK_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            end(new IOException("its reader was interrupted", e));
            return null;
        }
    }

    private boolean isUnread() {
        UnreadData open = unread;
        try {
            return open != null && open.isThere();
        } catch (IOException e) {
            return true;
        }
    }

    private void probe() {
        LiburbiWriter open = writer;
        if (open != null) {
            open.writeLater(NOTHING);
        }
    }

    private IOException cause() {
        IOException cause = end.get();
        return cause == null ? new IOException("closed") : cause;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
        LiburbiWriter open = writer;
        if (open == null || end.get() != null) {
            throw new IOException("the connection is closed");
        }
        open.write(bytes);
    }

    @Override
    public void close() {
        end(new IOException("closed"), false);
    }

    @Override
    public void abort() {
        end(new IOException("closed"), true);
    }

    private void end(IOException cause) {
        end(cause, true);
    }

    /** Ends the connection; returns false if it had ended before. */
    private boolean end(IOException cause, boolean discarding) {
        if (!end.compareAndSet(null, cause)) {
            return false;
        }
        SocketChannel open = socket;
        try {
            if (open != null && discarding) {
                open.setOption(StandardSocketOptions.SO_LINGER, 0);
            }
            closeWriter();
            UnreadData watched = unread;
            if (watched != null) {
                watched.close();
            }
            if (open != null) {
                open.close();
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a connection of liburbi-java", e);
        }
        incoming.offer(END);
        return true;
    }
}
