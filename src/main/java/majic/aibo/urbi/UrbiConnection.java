package majic.aibo.urbi;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import majic.bot.LinkLost;
import majic.driver.FirstBytes;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * One connection to an URBI server: writes commands, passes each answer to its request, and all other messages to a
 * listener. The server runs the commands of one connection in order, so each purpose has its own. Thread-safe.
 */
public final class UrbiConnection implements UrbiTransport.Receiver {
    private static final Logger LOG = System.getLogger(UrbiConnection.class.getName());

    /** The largest binary that fits with its header into the server's queue of 32 KiB (URBI sheet 2). */
    public static final int LARGEST_BINARY = 24 * 1024;

    private final String purpose;
    private final UrbiTransport transport;
    private final RobotWait waiting;
    private final Consumer<UrbiMessage> listener;
    private final BiConsumer<UrbiConnection, String> whenBroken;
    private final PendingRequests pending = new PendingRequests();
    private final FirstBytes foreign = new FirstBytes();
    private volatile boolean identified;
    private volatile boolean ended;
    private volatile boolean endExpected;
    private volatile UrbiVersion version = UrbiVersion.V1_0;
    private volatile long lastTimeMs;

    /**
     * Creates a connection; opens nothing.
     *
     * @param purpose names it in threads and the log
     * @param waiting woken by what it receives, and by its end
     * @param listener takes each message that answers no request, on the reader thread
     * @param whenBroken called once with the cause if the connection breaks, never after {@link #expectEnd}
     */
    public UrbiConnection(
            String purpose,
            UrbiTransport transport,
            RobotWait waiting,
            Consumer<UrbiMessage> listener,
            BiConsumer<UrbiConnection, String> whenBroken) {
        this.purpose = purpose;
        this.transport = transport;
        this.waiting = waiting;
        this.listener = listener;
        this.whenBroken = whenBroken;
    }

    /** Connects; messages are delivered from then on. */
    public void open(int timeoutMs) throws IOException {
        transport.open(timeoutMs, "aibo " + purpose, this);
    }

    @Override
    public void ended(IOException cause) {
        ended = true;
        waiting.changes().raise();
        breakDown(String.valueOf(cause.getMessage()));
    }

    @Override
    public void received(UrbiMessage message) {
        lastTimeMs = Math.max(lastTimeMs, message.timeMs());
        UrbiRequest answered = pending.answer(message, version);
        if (answered != null) {
            raiseIfDone(answered);
        } else if (message.tag().equals("ident")) {
            identified = true;
            waiting.changes().raise();
        } else {
            handleUnasked(message);
        }
    }

    private void handleUnasked(UrbiMessage message) {
        if (message.body() instanceof UrbiMessage.Continued line
                && message.tag().equals(UrbiMessage.NO_TAG)) {
            byte[] text = (line.text() + "\n").getBytes(StandardCharsets.ISO_8859_1);
            foreign.received(text, text.length);
        }
        if (message.tag().equals("start") && message.body() instanceof UrbiMessage.Info line) {
            version = UrbiVersion.of(line.text(), version);
        }
        listener.accept(message);
    }

    private void raiseIfDone(UrbiRequest ask) {
        if (ask.isDone()) {
            waiting.changes().raise();
        }
    }

    /** Stops waiting for the answer to a request. */
    public void forget(UrbiRequest ask) {
        pending.remove(ask);
    }

    /**
     * Writes commands, in one piece.
     *
     * @throws LinkLost if the connection is broken; {@code whenBroken} has been called
     * @throws UrbiRefusal if they are too long or harmful; nothing was sent
     */
    public void send(String commands) {
        CommandFilter.check(commands);
        transmit(commands);
    }

    private void transmit(String commands) {
        LOG.log(Level.TRACE, "{0} > {1}", purpose, commands);
        write((commands + "\n").getBytes(StandardCharsets.ISO_8859_1));
    }

    /**
     * Assigns a binary to a variable. The command has neither tag nor flag, and the bytes follow its separator at once;
     * otherwise the server would read them as a program (URBI sheet 12). No message reports its end.
     *
     * @param variable such as {@code speaker.val}
     * @param format the description of the bytes for the server, such as {@code raw 1 16000 16 1}
     * @param bytes at most {@value #LARGEST_BINARY}
     * @throws LinkLost if the connection is broken; {@code whenBroken} has been called
     * @throws UrbiRefusal if it is too long or harmful; nothing was sent
     */
    public void upload(String variable, String format, byte[] bytes) {
        String header = variable + " = BIN " + bytes.length + " " + format + ";";
        CommandFilter.check(header);
        if (bytes.length > LARGEST_BINARY) {
            throw new UrbiRefusal("the dog takes " + LARGEST_BINARY + " bytes at once, not " + bytes.length);
        }
        LOG.log(Level.TRACE, "{0} > {1}…", purpose, header);
        byte[] start = header.getBytes(StandardCharsets.ISO_8859_1);
        byte[] message = Arrays.copyOf(start, start.length + bytes.length);
        System.arraycopy(bytes, 0, message, start.length, bytes.length);
        write(message);
    }

    private void write(byte[] message) {
        try {
            transport.write(message);
        } catch (IOException e) {
            breakDown(String.valueOf(e.getMessage()));
            throw new LinkLost("connection lost: " + e.getMessage(), e);
        }
    }

    /**
     * Writes commands of which one is tagged with the ask's tag.
     *
     * @throws LinkLost if the connection is broken; {@code whenBroken} has been called
     * @throws UrbiRefusal if they are too long or harmful; nothing was sent, and nothing is expected
     */
    public UrbiRequest send(UrbiRequest ask, String commands) {
        CommandFilter.check(commands);
        pending.add(ask);
        transmit(commands);
        return ask;
    }

    /** Asks for a value, with a new tag for the answer. Throws as {@link #send} does. */
    public UrbiRequest ask(Tags tags, String expression) {
        UrbiRequest ask = new UrbiRequest(tags.next(), UrbiRequest.Expects.VALUE);
        return send(ask, version.labelled(ask.tag(), expression) + ";");
    }

    /**
     * Sends a ping; its answer shows that all commands sent before have arrived (URBI sheet 9). Throws as {@link #send}
     * does.
     */
    public UrbiRequest ping(Tags tags) {
        UrbiRequest pong = new UrbiRequest(tags.next(), UrbiRequest.Expects.PONG);
        return send(pong, pong.tag() + ": ping;");
    }

    private void breakDown(String why) {
        boolean first;
        synchronized (this) {
            first = !endExpected;
            endExpected = true;
        }
        if (first) {
            whenBroken.accept(this, why);
        }
    }

    /** Marks the end of this connection as expected: it is not reported as broken. */
    synchronized void expectEnd() {
        endExpected = true;
    }

    void close() {
        expectEnd();
        transport.close();
    }

    /** Closes at once and discards what is not yet sent, so that no command reaches the dog late. */
    public void abort() {
        expectEnd();
        transport.abort();
    }

    boolean isIdentified() {
        return identified;
    }

    /** The first line of text that came before any message of an URBI server; null if there is none. */
    @Nullable
    String foreignText() {
        return foreign.line();
    }

    public boolean isEnded() {
        return ended;
    }

    public UrbiVersion version() {
        return version;
    }

    /** The newest time stamp of the server, ms. */
    public long lastTimeMs() {
        return lastTimeMs;
    }
}
