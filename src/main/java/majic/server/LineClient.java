package majic.server;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.util.Optional;
import java.util.function.LongSupplier;
import majic.log.Line;
import majic.script.MajicParser;

/**
 * A connection of one client to a {@link LineServer}. The client's lines are carried out in order, at a limited rate; a
 * stop overtakes lines that are held and drops them. Must be used on the server's thread, except {@link #lineWritten},
 * {@link #isWaiting} and {@link #close}.
 */
final class LineClient {
    /** Maximum number of lines per second of a client; more are held. */
    static final int LINES_PER_SECOND = 200;

    /** Maximum number of stops per second of a client; more are held. */
    static final int STOPS_PER_SECOND = 20;

    private static final System.Logger LOG = System.getLogger(LineClient.class.getName());

    private static final int MOST_LINES = 10_000;
    private static final int MOST_CHARS = 2_000_000;
    private static final long ADMITTED_WITHIN_NANOS = 10_000_000_000L;
    private static final long LAST_ANSWERS_NANOS = 1_000_000_000L;

    private final LineServer server;
    private final SelectionKey key;
    private final Wire wire;
    private final InetAddress address;
    private final MajicParser parser;
    private final LongSupplier nanos;
    private final LineDecoder decoder = new LineDecoder();
    private final LineBuffer held = new LineBuffer(MOST_LINES, MOST_CHARS);
    private final Rate rate;
    private final Rate stopRate;
    private final AnswerQueue answers = new AnswerQueue(MOST_LINES, MOST_CHARS);
    private final long sinceNanos;
    private long lastLineNanos;
    private long dismissedNanos;
    private volatile boolean admitted;
    private volatile boolean receivesAll;
    private volatile boolean allAnswered;
    private volatile boolean ended;
    private volatile boolean dismissed;
    private boolean finished;
    private boolean outputEnded;

    LineClient(LineServer server, SelectionKey key, Wire wire, InetAddress address, MajicParser parser) {
        this.server = server;
        this.key = key;
        this.wire = wire;
        this.address = address;
        this.parser = parser;
        this.nanos = server.nanos();
        this.rate = new Rate(LINES_PER_SECOND, nanos);
        this.stopRate = new Rate(STOPS_PER_SECOND, nanos);
        this.sinceNanos = nanos.getAsLong();
        this.lastLineNanos = sinceNanos;
    }

    /**
     * Receives a line of the session, and queues it if it concerns this client. Called on the session's thread; never
     * blocks.
     */
    void lineWritten(Line line) {
        if (admitted && !dismissed && (receivesAll || line.concerns(parser))) {
            answers.add(line.text());
        }
    }

    /** Returns whether work remains that no further byte of the client triggers. */
    boolean isWaiting() {
        return ended || dismissed || !admitted || !held.isEmpty();
    }

    boolean isAdmitted() {
        return admitted;
    }

    /** Returns whether the client counts as one that may command the team. */
    boolean hasPlace() {
        return admitted && !dismissed && !isGone();
    }

    /** Returns whether the client sends no more lines. */
    boolean hasEnded() {
        return ended;
    }

    boolean isGone() {
        return !wire.isOpen();
    }

    InetAddress address() {
        return address;
    }

    /** Returns the time since its last line, or since it connected. */
    long idleNanos() {
        return nanos.getAsLong() - lastLineNanos;
    }

    /**
     * Reads the bytes that have arrived, without waiting for more.
     *
     * @param chunk a buffer to use
     */
    void read(ByteBuffer chunk) {
        try {
            int count = wire.read(chunk.clear());
            if (!dismissed) {
                decoder.feed(chunk.flip()).forEach(this::take);
            }
            if (count < 0 && !ended) {
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
        if (!admitted || dismissed) {
            close();
        } else if (parser.isStop(rest)) {
            stop(rest);
        } else if (!rest.isBlank()) {
            answers.add("the last line has no line end and was not obeyed: " + rest);
        }
    }

    private void take(String line) {
        if (dismissed || ended) {
            return;
        }
        lastLineNanos = nanos.getAsLong();
        if (!admitted) {
            admit(line);
        } else if (line.strip().equalsIgnoreCase("close")) {
            ended = true;
        } else if (stopRate.hasOne() && parser.isStop(line)) {
            stopRate.take();
            stop(line);
        } else {
            hold(line);
        }
    }

    private void admit(String line) {
        Admission admission = server.admission();
        Optional<String> refusal = admission.refusal(line, address, parser);
        if (refusal.isPresent()) {
            dismiss(refusal.get());
        } else if (!server.makeRoom()) {
            dismiss("MAJIC has " + ClientPlaces.MOST_CLIENTS
                    + " clients already, which is the most; close one of them");
        } else {
            receivesAll = admission.receivesAll(line);
            admitted = true;
            server.certificateWarning().ifPresent(answers::add);
            if (admission.isScript(line)) {
                take(line);
            }
        }
    }

    private void stop(String line) {
        if (!held.isEmpty()) {
            answers.add(held.size() + (held.size() == 1 ? " line" : " lines") + " not run: stopped");
            held.clear();
        }
        parser.parseText(line);
    }

    private void hold(String line) {
        if (!held.add(line)) {
            dismiss("closed: more than " + MOST_LINES + " lines wait, or " + MOST_CHARS / 1_000_000
                    + " million characters, at " + LINES_PER_SECOND
                    + " lines a second; wait for answers before sending more");
        }
    }

    /** Drops all that waits, sends the reason, and closes the connection as soon as it is sent. */
    void dismiss(String why) {
        dismissed = true;
        dismissedNanos = nanos.getAsLong();
        held.clear();
        answers.replaceBy(why);
    }

    /**
     * Does what can be done now: runs held lines, sends answers, ends the connection.
     *
     * @return whether there is more to do at once, when the other clients had their turn
     */
    boolean work() {
        try {
            boolean more = runHeld();
            checkLimits();
            finish();
            answers.send(wire);
            endIfOver();
            showInterest();
            return more;
        } catch (IOException | CancelledKeyException e) {
            LOG.log(Level.DEBUG, "a client is gone", e);
            close();
            return false;
        }
    }

    /**
     * Carries out one line before the other clients' bytes are read again, so that a stop among these waits for few.
     */
    private boolean runHeld() {
        String line = held.peek();
        if (line == null || !mayRun(line)) {
            return false;
        }
        held.poll();
        parser.parseText(line);
        return !held.isEmpty();
    }

    private boolean mayRun(String line) {
        return parser.isStop(line) ? stopRate.take() : server.isReady() && parser.hasRoom() && rate.take();
    }

    private void checkLimits() {
        boolean isLate = !admitted && nanos.getAsLong() - sinceNanos > ADMITTED_WITHIN_NANOS;
        if (isLate && !dismissed && server.admission().token().isPresent()) {
            dismiss("no token came within " + ADMITTED_WITHIN_NANOS / 1_000_000_000 + " s");
        }
        if (answers.hasOverflowed() && !dismissed) {
            LOG.log(Level.WARNING, "a client at {0} does not read its answers; closed", address.getHostAddress());
            dismiss("closed: the answers were not read");
        }
    }

    private void finish() {
        if (ended && !finished && held.isEmpty()) {
            parser.finish();
            if (parser.isDone()) {
                finished = true;
                server.afterwards(() -> allAnswered = true);
            }
        }
    }

    /**
     * Ends a connection whose last answer is sent. A dismissed client may be sending: if the connection were closed
     * with unread bytes, the reason would be lost, so the client has a second to close its side.
     */
    private void endIfOver() throws IOException {
        boolean isSent = answers.isEmpty() && !wire.hasUnsent();
        if (dismissed && isSent && !outputEnded) {
            outputEnded = true;
            wire.endOutput();
        }
        if ((allAnswered && isSent) || (dismissed && nanos.getAsLong() - dismissedNanos > LAST_ANSWERS_NANOS)) {
            close();
        }
    }

    private void showInterest() {
        if (key.isValid()) {
            boolean reads = !ended && !wire.isBusy();
            boolean writes = wire.hasUnsent() || (wire.isReady() && !answers.isEmpty());
            key.interestOps((reads ? SelectionKey.OP_READ : 0) | (writes ? SelectionKey.OP_WRITE : 0));
        }
    }

    /** Ends the connection; lines that were submitted already are still carried out. */
    void close() {
        try {
            wire.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a client", e);
        }
    }
}
