package majic.server;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import majic.log.Line;
import majic.script.MajicParser;
import org.jspecify.annotations.Nullable;

/**
 * A connection of one client to a {@link LineServer}. The client's lines are carried out in order, at a limited rate; a
 * stop overtakes lines that are held and drops them. Must be used on the server's thread, except {@link #lineWritten} and
 * {@link #close}.
 */
final class LineClient {
    /** Maximum number of lines per second of a client; more are held. */
    static final int LINES_PER_SECOND = 200;

    private static final System.Logger LOG = System.getLogger(LineClient.class.getName());
    private static final int STOPS_PER_SECOND = 20;
    private static final int MOST_HELD = 10_000;
    private static final int MOST_UNREAD_ANSWERS = 10_000;
    private static final int CHUNK = 8192;
    private static final long TOKEN_WITHIN_NANOS = 5_000_000_000L;
    private static final long LAST_ANSWERS_NANOS = 1_000_000_000L;

    private final LineServer server;
    private final SelectionKey key;
    private final SocketChannel socket;
    private final MajicParser parser;
    private final LineDecoder decoder = new LineDecoder();
    private final Deque<String> held = new ArrayDeque<>();
    private final LineRate rate = new LineRate(LINES_PER_SECOND, System::nanoTime);
    private final LineRate stopRate = new LineRate(STOPS_PER_SECOND, System::nanoTime);
    private final BlockingQueue<String> answers = new ArrayBlockingQueue<>(MOST_UNREAD_ANSWERS);
    private final long sinceNanos = System.nanoTime();
    private @Nullable ByteBuffer unsent;
    private long dismissedNanos;
    private volatile boolean admitted;
    private volatile boolean receivesAll;
    private volatile boolean answersOverflowed;
    private volatile boolean allAnswered;
    private boolean ended;
    private boolean finished;
    private boolean dismissed;

    LineClient(LineServer server, SelectionKey key, MajicParser parser) {
        this.server = server;
        this.key = key;
        this.socket = (SocketChannel) key.channel();
        this.parser = parser;
    }

    /**
     * Receives a line of the session, and queues it if it concerns this client. Called on the session's thread; never
     * blocks.
     */
    void lineWritten(Line line) {
        if (admitted && (receivesAll || line.concerns(parser))) {
            answer(line.text());
        }
    }

    private void answer(String text) {
        answersOverflowed |= !answers.offer(text);
    }

    /** Returns whether work remains that no further byte of the client triggers. */
    boolean isWaiting() {
        return ended || dismissed || !admitted || !held.isEmpty();
    }

    /** Returns whether the client sends no more lines. */
    boolean hasEnded() {
        return ended;
    }

    boolean isGone() {
        return !socket.isOpen();
    }

    /** Reads the bytes that have arrived, without waiting for more. */
    void read() {
        ByteBuffer chunk = ByteBuffer.allocate(CHUNK);
        try {
            int count = socket.read(chunk);
            decoder.feed(chunk.flip()).forEach(this::take);
            if (count < 0) {
                end();
            }
        } catch (IOException | CancelledKeyException e) {
            LOG.log(Level.DEBUG, "a client is gone", e);
            close();
        }
    }

    private void end() {
        String rest = decoder.rest();
        ended = true;
        if (!admitted) {
            close();
        } else if (parser.isStop(rest)) {
            take(rest);
        } else if (!rest.isBlank() && !dismissed) {
            answer("the last line has no line end and was not obeyed: " + rest);
        }
        showInterest();
    }

    private void take(String line) {
        if (dismissed) {
            return;
        }
        if (!admitted) {
            admit(line);
        } else if (!held.isEmpty() && parser.isStop(line) && stopRate.take()) {
            overtake(line);
        } else if (!held.isEmpty() || !mayRun(line)) {
            hold(line);
        } else {
            parser.parseText(line);
        }
    }

    /**
     * Checks the first line: a web page can make a browser connect, but the browser's first line is neither the token
     * nor MAJIC Script.
     */
    private void admit(String line) {
        String[] words = line.strip().split("\\s+", 2);
        boolean all = words[words.length - 1].toLowerCase(Locale.ROOT).equals("all");
        if (server.token().isPresent()) {
            boolean right = server.token().get().is(words[0]) && (words.length == 1 || all);
            if (!right) {
                dismiss("the first line must be the token that MAJIC printed at its start; it is also in "
                        + server.token().get().file());
                return;
            }
        } else if (words.length > 1 || !all) {
            admitScript(line);
            return;
        }
        receivesAll = all && (words.length > 1 || server.token().isEmpty());
        admitted = true;
    }

    private void admitScript(String line) {
        if (parser.isScript(line)) {
            admitted = true;
            take(line);
        } else {
            dismiss("the first line must be MAJIC Script, for instance: bots");
        }
    }

    private boolean mayRun(String line) {
        return parser.isStop(line) || (server.isReady() && parser.hasRoom() && rate.take());
    }

    private void overtake(String line) {
        answer(held.size() + (held.size() == 1 ? " line" : " lines") + " not run: stopped");
        held.clear();
        parser.parseText(line);
    }

    private void hold(String line) {
        if (held.size() >= MOST_HELD) {
            dismiss("more than " + MOST_HELD + " lines wait, at " + LINES_PER_SECOND
                    + " lines a second; wait for answers before sending more");
            held.clear();
        } else {
            held.add(line);
        }
    }

    /** Sends the reason, and closes the connection as soon as it is sent. */
    private void dismiss(String why) {
        answers.clear();
        answer(why);
        dismissed = true;
        dismissedNanos = System.nanoTime();
    }

    /** Does what can be done now: runs held lines, sends answers, ends the connection. */
    void work() {
        try {
            while (!held.isEmpty() && mayRun(held.element())) {
                parser.parseText(held.remove());
            }
            finish();
            send();
            if (answersOverflowed) {
                LOG.log(Level.WARNING, "a client does not read its answers; dropped");
                close();
            } else if (isOver()) {
                close();
            }
        } catch (IOException | CancelledKeyException e) {
            LOG.log(Level.DEBUG, "a client is gone", e);
            close();
        }
    }

    private void finish() {
        if (!admitted
                && !dismissed
                && System.nanoTime() - sinceNanos > TOKEN_WITHIN_NANOS
                && server.token().isPresent()) {
            dismiss("no token came within 5 s");
        }
        if (ended && !finished && held.isEmpty()) {
            parser.finish();
            if (parser.isDone()) {
                finished = true;
                server.afterwards(() -> allAnswered = true);
            }
        }
    }

    private boolean isOver() {
        boolean sent = unsent == null && answers.isEmpty();
        return (dismissed && (sent || System.nanoTime() - dismissedNanos > LAST_ANSWERS_NANOS))
                || (allAnswered && sent);
    }

    private void send() throws IOException {
        if (unsent == null) {
            unsent = next();
        }
        while (unsent != null && socket.isOpen()) {
            socket.write(unsent);
            if (unsent.hasRemaining()) {
                break;
            }
            unsent = next();
        }
        showInterest();
    }

    private @Nullable ByteBuffer next() {
        String answer = answers.poll();
        return answer == null ? null : ByteBuffer.wrap((answer + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private void showInterest() {
        if (key.isValid()) {
            key.interestOps((ended ? 0 : SelectionKey.OP_READ) | (unsent == null ? 0 : SelectionKey.OP_WRITE));
        }
    }

    /** Ends the connection; lines that were submitted already are still carried out. */
    void close() {
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a client", e);
        }
    }
}
