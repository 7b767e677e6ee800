package majic.hemisson;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Locale;
import majic.bot.TimeSource;
import majic.link.Link;
import org.jspecify.annotations.Nullable;

/** One connection, from opening to its end: the link, its reader thread and the conversation over it. */
final class Session {
    private static final Logger LOG = System.getLogger(Session.class.getName());

    /** How long an answer may take on a cable or over TCP, seconds (Hemisson sheet 4.6). */
    static final double CABLE_TIMEOUT_S = 0.3;

    /** The same through a radio that stands for the cable. */
    static final double BLUETOOTH_TIMEOUT_S = 1;

    private final Link link;
    private final ConversationListener listener;
    private final Conversation conversation;
    private final LineDecoder decoder = new LineDecoder();
    private final double timeoutSeconds;
    private volatile boolean closed;
    private volatile @Nullable String end;
    private volatile boolean telnet;

    Session(Link link, TimeSource time, ConversationListener listener) {
        this.link = link;
        this.listener = listener;
        this.timeoutSeconds = isBluetooth(link.address()) ? BLUETOOTH_TIMEOUT_S : CABLE_TIMEOUT_S;
        this.conversation = new Conversation(link, time, timeoutSeconds, listener);
    }

    void start() {
        Thread reader = new Thread(this::readLoop, "hemisson reader");
        reader.setDaemon(true);
        reader.start();
    }

    Conversation conversation() {
        return conversation;
    }

    /** How long an answer may take, seconds. */
    double timeoutSeconds() {
        return timeoutSeconds;
    }

    /** Whether the peer negotiates telnet options, so that what it sends is no raw serial line. */
    boolean isTelnet() {
        return telnet;
    }

    boolean isClosed() {
        return closed;
    }

    /** How the link came to its end by itself; null if it did not. */
    @Nullable
    String end() {
        return end;
    }

    void close() {
        closed = true;
        conversation.end("the connection was closed");
        link.close();
    }

    static boolean isBluetooth(String address) {
        return address.contains("rfcomm") || address.toLowerCase(Locale.ROOT).contains("bluetooth");
    }

    private void readLoop() {
        byte[] chunk = new byte[512];
        try {
            for (int count = link.read(chunk); count >= 0; count = link.read(chunk)) {
                take(chunk, count);
            }
            broken(new IOException(
                    link.address().startsWith("serial:") ? "the serial port is gone" : "the serial server closed it"));
        } catch (IOException e) {
            broken(e);
        }
    }

    private void take(byte[] chunk, int count) {
        conversation.heard();
        List<String> lines = decoder.feed(chunk, count);
        telnet = decoder.isTelnet();
        lines.forEach(line -> receive(Reply.of(line)));
    }

    /** Whatever a line does to its hearer, the next ones are read: the answer to a stop may be among them. */
    private void receive(Reply reply) {
        try {
            conversation.received(reply);
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "could not take in " + reply.text(), e);
        }
    }

    private void broken(IOException cause) {
        if (!closed) {
            end = cause.getMessage();
            listener.broken(cause);
        }
    }
}
