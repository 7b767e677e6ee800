package majic.aibo.urbi;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.time.TimeSource;

/** Carries messages over a link, decoded by {@link UrbiDecoder}. */
public final class LinkTransport implements UrbiTransport {
    private static final Logger LOG = System.getLogger(LinkTransport.class.getName());

    /**
     * A binary without progress for so long may be cut short, seconds; less than the silence at which a walking dog is
     * stopped.
     */
    private static final double STALLED_S = 1;

    private final Link link;
    private final TimeSource time;

    /**
     * Makes a transport over a link that is not open.
     *
     * @param link to the server
     * @param time the robot's clock
     */
    public LinkTransport(Link link, TimeSource time) {
        this.link = link;
        this.time = time;
    }

    @Override
    public void open(int timeoutMs, String name, Receiver receiver) throws IOException {
        link.open(timeoutMs);
        new LinkReader<>(link, "the dog closed it", new Decoding(name, receiver, time)).start(name + " reader");
    }

    @Override
    public void write(byte[] bytes) throws IOException {
        link.write(bytes);
    }

    @Override
    public void close() {
        link.close();
    }

    @Override
    public void abort() {
        link.abort();
    }

    /** Decodes what the link receives; for its reader thread. */
    static final class Decoding implements LinkHandler<UrbiMessage> {
        private final String name;
        private final Receiver receiver;
        private final TimeSource time;
        private final UrbiDecoder decoder = new UrbiDecoder();
        private boolean inBinary;
        private long sinceNanos;

        Decoding(String name, Receiver receiver, TimeSource time) {
            this.name = name;
            this.receiver = receiver;
            this.time = time;
        }

        @Override
        public void decode(byte[] bytes, int count, Consumer<UrbiMessage> messages) {
            if (LOG.isLoggable(Level.TRACE)) {
                LOG.log(Level.TRACE, "{0} < {1}", name, new String(bytes, 0, count, StandardCharsets.ISO_8859_1));
            }
            List<UrbiMessage> found = decoder.feed(bytes, count);
            found.forEach(messages);
            boolean sameBinary = inBinary && decoder.isInBinary() && found.isEmpty();
            if (!sameBinary) {
                inBinary = decoder.isInBinary();
                sinceNanos = time.nanos();
            } else if (time.secondsSince(sinceNanos) > STALLED_S) {
                decoder.giveUpCutBinary().forEach(messages);
                sinceNanos = time.nanos();
            }
        }

        @Override
        public void received(UrbiMessage message) {
            receiver.received(message);
        }

        @Override
        public void ended(IOException cause) {
            receiver.ended(cause);
        }
    }
}
