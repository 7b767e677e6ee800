package majic.aibo;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import majic.bot.LinkLost;
import majic.link.Link;
import org.jspecify.annotations.Nullable;

/**
 * One connection to an URBI server: writes commands, hands each answer to whoever asked, and everything else to its
 * owner. Commands of one connection run in order, so each purpose has its own. Safe from any thread.
 */
final class UrbiConnection {
    private static final Logger LOG = System.getLogger(UrbiConnection.class.getName());

    /** A syntax error names a place; other troubles under the same tag answer no command (URBI sheet 11). */
    private static final Pattern ANSWERS_A_COMMAND = Pattern.compile("\\d+\\.\\d.*|Receive buffer.*");

    /** Who hears what nobody asked for. Called on the reader's thread. */
    interface Owner {
        /** A message that answers no command. */
        void heard(UrbiMessage message);

        /** The connection broke; called once, never after {@link #leave}. */
        void broken(UrbiConnection connection, String why);
    }

    private final String purpose;
    private final Link link;
    private final Owner owner;
    private final Watch watch;
    private final Map<String, Ask> unanswered = new LinkedHashMap<>();
    private volatile boolean identified;
    private volatile boolean ended;
    private volatile boolean leaving;
    private volatile Dialect dialect = Dialect.V1_0;
    private volatile long lastTimeMs;

    UrbiConnection(String purpose, Link link, Owner owner, Watch watch) {
        this.purpose = purpose;
        this.link = link;
        this.owner = owner;
        this.watch = watch;
    }

    /** Opens the link and starts to listen. */
    void open(int timeoutMs) throws IOException {
        link.open(timeoutMs);
        Thread reader = new Thread(this::readLoop, "aibo " + purpose + " reader");
        reader.setDaemon(true);
        reader.start();
    }

    private void readLoop() {
        UrbiDecoder decoder = new UrbiDecoder();
        byte[] chunk = new byte[4096];
        String why = "the dog closed it";
        try {
            for (int count = link.read(chunk); count >= 0; count = link.read(chunk)) {
                logIncoming(chunk, count);
                decoder.feed(chunk, count).forEach(this::handle);
            }
        } catch (IOException e) {
            why = String.valueOf(e.getMessage());
        }
        ended = true;
        watch.changes().raise();
        breakDown(why);
    }

    private void handle(UrbiMessage message) {
        lastTimeMs = Math.max(lastTimeMs, message.timeMs());
        Ask ask = answered(message);
        if (ask != null) {
            ask.accept(message);
            forgetIfDone(ask);
        } else if (message.tag().equals("ident")) {
            identified = true;
            watch.changes().raise();
        } else if (message.tag().equals("error")) {
            handleError(message);
        } else {
            handleUnasked(message);
        }
    }

    private void handleUnasked(UrbiMessage message) {
        if (message.tag().equals("start") && message.body() instanceof UrbiMessage.Info line) {
            dialect = Dialect.of(line.text(), dialect);
        }
        owner.heard(message);
    }

    /** A syntax error carries the tag {@code error} whatever the command's was, so the oldest open one is meant. */
    private void handleError(UrbiMessage message) {
        Ask oldest = oldestUnanswered();
        boolean answers = message.body() instanceof UrbiMessage.Failure wrong
                && ANSWERS_A_COMMAND.matcher(wrong.text()).matches();
        if (oldest != null && answers) {
            oldest.accept(message);
            forgetIfDone(oldest);
        } else {
            owner.heard(message);
        }
    }

    private @Nullable Ask answered(UrbiMessage message) {
        synchronized (unanswered) {
            return unanswered.get(message.tag());
        }
    }

    private @Nullable Ask oldestUnanswered() {
        synchronized (unanswered) {
            return unanswered.values().stream().findFirst().orElse(null);
        }
    }

    private void forgetIfDone(Ask ask) {
        if (ask.isDone()) {
            forget(ask);
            watch.changes().raise();
        }
    }

    /** Expects nothing more for a command. */
    void forget(Ask ask) {
        synchronized (unanswered) {
            unanswered.remove(ask.tag());
        }
    }

    /**
     * Writes commands, in one piece.
     *
     * @throws LinkLost if the connection is broken; its owner knows then
     */
    void send(String commands) {
        LOG.log(Level.TRACE, "{0} > {1}", purpose, commands);
        try {
            link.write((commands + "\n").getBytes(StandardCharsets.ISO_8859_1));
        } catch (IOException e) {
            breakDown(String.valueOf(e.getMessage()));
            throw new LinkLost("connection lost: " + e.getMessage(), e);
        }
    }

    /** Writes commands of which one is tagged with the ask's tag. */
    Ask send(Ask ask, String commands) {
        synchronized (unanswered) {
            unanswered.put(ask.tag(), ask);
        }
        send(commands);
        return ask;
    }

    private void breakDown(String why) {
        boolean first;
        synchronized (this) {
            first = !leaving;
            leaving = true;
        }
        if (first) {
            owner.broken(this, why);
        }
    }

    /** Says that the end of this connection will be no surprise. */
    synchronized void leave() {
        leaving = true;
    }

    void close() {
        leave();
        link.close();
    }

    /** Closes and throws away what has not gone out yet, so that no command reaches the dog late. */
    void abort() {
        leave();
        link.abort();
    }

    boolean isIdentified() {
        return identified;
    }

    boolean isEnded() {
        return ended;
    }

    Dialect dialect() {
        return dialect;
    }

    /** The newest time stamp of the server, ms. */
    long lastTimeMs() {
        return lastTimeMs;
    }

    private void logIncoming(byte[] chunk, int count) {
        if (LOG.isLoggable(Level.TRACE)) {
            LOG.log(Level.TRACE, "{0} < {1}", purpose, new String(chunk, 0, count, StandardCharsets.ISO_8859_1));
        }
    }
}
