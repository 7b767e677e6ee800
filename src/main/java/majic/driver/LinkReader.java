package majic.driver;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;
import majic.link.Link;
import majic.text.ClassReason;
import majic.time.WaitPolicy;

/**
 * Reads a link on a daemon thread and passes each message to its handler. The thread delivers the answers of the robot,
 * so it must not wait for one: it runs without {@link WaitPolicy}.
 *
 * <p>Everything thrown, {@link Error} included, is handled alike. What {@link LinkHandler#received} throws is logged
 * and affects that message only: the link stays open, because a stop has to be sent over it and its answer may be the
 * next message. If no useful messages arrive any more, the driver's timeouts notice it. What reading or decoding throws
 * ends the link, as its close by the peer does: the handler is notified once.
 *
 * @param <M> a message of the protocol
 */
public final class LinkReader<M> {
    private static final Logger LOG = System.getLogger(LinkReader.class.getName());
    private static final int CHUNK = 4096;
    private static final String SERIAL = "serial:";

    /** The message of Java for a connection that its peer has reset. */
    private static final String RESET = "Connection reset";

    private final Link link;
    private final String closed;
    private final LinkHandler<M> handler;

    /**
     * Creates a reader; reads nothing yet.
     *
     * @param link open when {@link #start} is called
     * @param closed the cause reported when the peer closes a network link, as half a sentence: "the robot closed it"
     * @param handler receives the messages
     */
    public LinkReader(Link link, String closed, LinkHandler<M> handler) {
        this.link = link;
        this.closed = closed;
        this.handler = handler;
    }

    /**
     * Starts the thread. It ends with the link.
     *
     * @param name the name of the thread
     */
    public void start(String name) {
        Thread reader = new Thread(() -> WaitPolicy.without(this::run), name);
        reader.setDaemon(true);
        reader.start();
    }

    private void run() {
        IOException cause = readToTheEnd();
        try {
            handler.ended(cause);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "the end of " + link.address() + " could not be handled", e);
        }
    }

    private IOException readToTheEnd() {
        byte[] chunk = new byte[CHUNK];
        Consumer<M> each = this::receive;
        try {
            for (int count = link.read(chunk); count >= 0; count = link.read(chunk)) {
                handler.decode(chunk, count, each);
            }
            return new IOException(closedBy(link.address()));
        } catch (IOException e) {
            return RESET.equals(e.getMessage()) ? new IOException("the other end reset it", e) : e;
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "could not read " + link.address(), e);
            return new IOException(ClassReason.ofUnexpected(e), e);
        }
    }

    /** The cause of the end of the link, worded as a failed write to a serial port is. */
    private String closedBy(String address) {
        return address.startsWith(SERIAL)
                ? "the serial port " + address.substring(SERIAL.length()) + " is gone"
                : closed;
    }

    private void receive(M message) {
        try {
            handler.received(message);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "could not process " + message, e);
        }
    }
}
