package majic.ros.websocket;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import majic.bot.LinkLost;
import majic.driver.FirstBytes;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One WebSocket connection, from the client's side. Any thread may send; each message is one frame, written on the
 * calling thread within {@link Link#WRITE_DEADLINE_MS}. Thread-safe.
 */
public final class WebSocketClient implements AutoCloseable {
    private static final Logger LOG = System.getLogger(WebSocketClient.class.getName());

    /** The code of an ordinary end (RFC 6455, 7.4.1). */
    private static final int NORMAL_END = 1000;

    private final Link link;
    private final TimeSource time;
    private final Listener listener;
    private final Upgrade upgrade;
    private final ServerBytes decoder;
    private final Signal changes;
    private final FirstBytes firstBytes = new FirstBytes();
    private final PingTimes pings = new PingTimes();
    private final FrameEncoder encoder = new FrameEncoder();
    private volatile boolean answered;
    private volatile @Nullable String refusal;
    private volatile @Nullable IOException end;
    private volatile @Nullable String closeReason;
    private volatile long heardNanos;

    /** Handles what arrives. Called on the reader thread, which must not wait; what it throws is logged. */
    public interface Listener {
        /**
         * Handles a text message.
         *
         * @param text all of it
         */
        void text(String text);

        /**
         * Handles a binary message.
         *
         * @param bytes all of it
         */
        void binary(byte[] bytes);

        /** Handles a message that is longer than the limit and was skipped. */
        void tooLong();

        /**
         * Handles the end of the connection. Called once, last, after a successful {@link #open} or during one.
         *
         * @param cause why, as half a sentence
         */
        void ended(IOException cause);
    }

    /**
     * Creates a client; opens nothing.
     *
     * @param link to the server, not open
     * @param host the server as the address names it, with its port
     * @param path of the server's service, with a slash at its beginning
     * @param mostBytes the length of the longest message that is received
     * @param time the clock of waits and of {@link #silenceS()}
     * @param listener handles what arrives
     */
    public WebSocketClient(Link link, String host, String path, int mostBytes, TimeSource time, Listener listener) {
        this.link = link;
        this.time = time;
        this.listener = listener;
        this.upgrade = new Upgrade(host, path);
        this.decoder = new ServerBytes(mostBytes);
        this.changes = time.signal();
    }

    /**
     * Connects.
     *
     * @param timeoutMs how long to try at most, ms
     * @throws NotWebSocket if something answers, but not as a WebSocket server
     * @throws IOException if nothing answers; the message is a sentence with the reason
     */
    public void open(int timeoutMs) throws IOException {
        try {
            openLink(timeoutMs);
            awaitAnswer(timeoutMs / 1000.0);
        } catch (IOException | RuntimeException e) {
            link.abort();
            throw e;
        }
    }

    private void openLink(int timeoutMs) throws IOException {
        link.open(timeoutMs);
        heardNanos = time.nanos();
        new LinkReader<>(link, "the rosbridge server closed it", new Handler()).start("ros reader");
        link.write(upgrade.request());
    }

    private void awaitAnswer(double seconds) throws IOException {
        boolean over;
        try {
            over = changes.await(() -> answered || end != null, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while connecting", e);
        }
        String refused = refusal;
        if (refused != null) {
            throw new NotWebSocket(refused);
        }
        IOException ended = end;
        if (!answered && (ended != null || !firstBytes.isEmpty())) {
            throw new NotWebSocket(firstBytes.line());
        }
        if (!over) {
            throw new SocketTimeoutException("it was reached, but did not answer within " + seconds + " s");
        }
    }

    /**
     * Sends a text message.
     *
     * @param text all of it
     * @throws LinkLost if it could not be sent; the connection is dead then
     */
    public void send(String text) {
        send(Opcode.TEXT, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Asks the server for a sign of life, which counts for {@link #silenceS()} and measures {@link #roundTripS()}.
     *
     * @throws LinkLost if it could not be sent; the connection is dead then
     */
    public void ping() {
        send(Opcode.PING, pings.ping(time.nanos()));
    }

    private void send(Opcode opcode, byte[] content) {
        String closed = closeReason;
        if (closed != null) {
            throw new LinkLost(closed);
        }
        write(opcode, content);
    }

    private void write(Opcode opcode, byte[] content) {
        try {
            link.write(encoder.encode(opcode, content));
        } catch (IOException e) {
            throw new LinkLost(String.valueOf(e.getMessage()), e);
        }
    }

    /**
     * Returns how long nothing arrived, pongs included.
     *
     * @return seconds since the last byte, or since the connection was made
     */
    public double silenceS() {
        return time.secondsSince(heardNanos);
    }

    /**
     * Returns how long a message takes to the server and back, by the newest ping.
     *
     * @return seconds; at least the time that an answer has been due; 0 before the first answer
     */
    public double roundTripS() {
        return pings.seconds(time.nanos());
    }

    /**
     * Returns how much has arrived of a message that is not complete.
     *
     * @return bytes; 0 between messages
     */
    public long arrivedBytes() {
        return decoder.frames().arrivedBytes();
    }

    /**
     * Returns the length of this message as far as it is known.
     *
     * @return bytes
     */
    public long knownBytes() {
        return decoder.frames().knownBytes();
    }

    /**
     * Returns whether the connection can be used.
     *
     * @return true from the server's consent until the end of the connection
     */
    public boolean isOpen() {
        return answered && refusal == null && end == null;
    }

    /**
     * Ends the connection in order: announces it, and waits until the server has closed it. An interruption ends the
     * wait.
     *
     * @param seconds the longest wait
     */
    public void close(double seconds) {
        if (isOpen()) {
            try {
                send(Opcode.CLOSE, closeContent());
                closeReason = "it is closed";
                changes.await(() -> end != null, seconds);
            } catch (LinkLost e) {
                LOG.log(Level.DEBUG, "the close was not sent", e);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
        link.close();
    }

    /** Ends the connection at once. */
    @Override
    public void close() {
        close(0);
    }

    /** Cuts the connection, for one that does not answer any more; wakes the thread that waits for a write. */
    public void abort() {
        link.abort();
    }

    private static byte[] closeContent() {
        return ByteBuffer.allocate(Short.BYTES).putShort((short) NORMAL_END).array();
    }

    /** Handles what the reader thread decodes. */
    private final class Handler implements LinkHandler<WebSocketMessage> {
        @Override
        public void decode(byte[] bytes, int count, Consumer<WebSocketMessage> messages) {
            heardNanos = time.nanos();
            if (!answered) {
                firstBytes.received(bytes, count);
            }
            decoder.decode(bytes, count, messages);
        }

        @Override
        public void received(WebSocketMessage message) {
            if (message instanceof WebSocketMessage.Answer answer) {
                refusal = upgrade.refusal(answer.head());
                answered = true;
                changes.raise();
            } else if (message instanceof WebSocketMessage.Text text) {
                listener.text(text.text());
            } else if (message instanceof WebSocketMessage.Binary binary) {
                listener.binary(binary.bytes());
            } else if (message instanceof WebSocketMessage.TooLong) {
                listener.tooLong();
            } else if (message instanceof WebSocketMessage.Ping ping) {
                send(Opcode.PONG, ping.content());
            } else if (message instanceof WebSocketMessage.Pong pong) {
                pings.pong(pong.content(), time.nanos());
            } else if (message instanceof WebSocketMessage.Close close) {
                closedByServer(close);
            } else if (message instanceof WebSocketMessage.Violation violation) {
                closeReason = "the server sent " + violation.what();
                link.close();
            }
        }

        /** Agrees; the server then closes the link, which ends the reader thread. */
        private void closedByServer(WebSocketMessage.Close close) {
            boolean first = closeReason == null;
            String reason =
                    close.reason().isBlank() ? "" : ": " + close.reason().strip();
            closeReason = "the rosbridge server closed it (" + close.code() + reason + ")";
            if (first) {
                write(Opcode.CLOSE, closeContent());
            }
        }

        @Override
        public void ended(IOException cause) {
            link.close();
            String reason = closeReason;
            IOException why = reason == null ? cause : new IOException(reason);
            end = why;
            changes.raise();
            listener.ended(why);
        }
    }
}
