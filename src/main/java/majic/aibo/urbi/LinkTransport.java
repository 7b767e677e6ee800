package majic.aibo.urbi;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.time.TimeSource;

/** Carries messages over a link, decoded by {@link UrbiDecoder}. */
public final class LinkTransport implements UrbiTransport {
    private static final Logger LOG = System.getLogger(LinkTransport.class.getName());

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
        new LinkReader<>(link, "the dog closed it", new Decoding(name, receiver)).start(name + " reader");
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

    /** Decodes what the link receives. */
    private final class Decoding implements LinkHandler<UrbiMessage> {
        private final UrbiReader reader = new UrbiReader(time);
        private final String name;
        private final Receiver receiver;

        Decoding(String name, Receiver receiver) {
            this.name = name;
            this.receiver = receiver;
        }

        @Override
        public void decode(byte[] bytes, int count, Consumer<UrbiMessage> messages) {
            if (LOG.isLoggable(Level.TRACE)) {
                LOG.log(Level.TRACE, "{0} < {1}", name, new String(bytes, 0, count, StandardCharsets.ISO_8859_1));
            }
            reader.read(bytes, count).forEach(messages);
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
