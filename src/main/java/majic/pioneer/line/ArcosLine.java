package majic.pioneer.line;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.driver.FirstBytes;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.session.RobotLine;
import majic.time.SuspendDetector;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Sends and receives the packets of one connection. Any thread may send, each packet in one write; packets are received
 * one after the other on the reader thread, which also reports the end, once.
 */
final class ArcosLine implements RobotLine, LinkHandler<Packet> {
    private static final Logger LOG = System.getLogger(ArcosLine.class.getName());
    private static final int OPEN_TIMEOUT_MS = 5000;

    /** A partial packet is dropped after so long (ARCOS sheet 14.1), seconds. */
    private static final double FRAGMENT_S = 0.3;

    private final Link link;
    private final TimeSource time;
    private final FrameDecoder decoder = new FrameDecoder();
    private final FirstBytes firstBytes = new FirstBytes();
    private final SuspendDetector suspend = new SuspendDetector();
    private final Listener listener;

    /** When bytes last came; for the reader thread. */
    private long lastNanos;

    private volatile int baud = BaudRates.POWER_UP;
    private volatile long sentNanos;
    private volatile @Nullable LinkLost end;

    /** Is notified by the reader thread. */
    interface Listener {
        /** A packet came. Must not wait for anything. */
        void received(Packet packet);

        /** The line has ended. */
        void ended(LinkLost cause);
    }

    ArcosLine(Link link, TimeSource time, Listener listener) {
        this.link = link;
        this.time = time;
        this.listener = listener;
    }

    /**
     * Opens the link and starts reading.
     *
     * @throws ConnectFailed if it cannot be opened; the message says why
     */
    void open() {
        try {
            link.open(OPEN_TIMEOUT_MS);
        } catch (IOException e) {
            throw ConnectFailed.of(e);
        }
        lastNanos = time.nanos();
        new LinkReader<>(link, "the robot closed it", this).start("pioneer reader " + link.address());
    }

    @Override
    public void decode(byte[] bytes, int count, Consumer<Packet> messages) {
        long nowNanos = time.nanos();
        if ((nowNanos - lastNanos) / 1e9 > FRAGMENT_S) {
            decoder.dropFragment(messages);
        }
        lastNanos = nowNanos;
        firstBytes.received(bytes, count);
        decoder.feed(bytes, count, messages);
    }

    @Override
    public void received(Packet packet) {
        trace("< ", packet);
        listener.received(packet);
    }

    @Override
    public void ended(IOException cause) {
        LinkLost first = end(new LinkLost("connection lost: " + cause.getMessage(), cause));
        link.close();
        listener.ended(first);
    }

    /** Sends packets, each in a write of its own. */
    @Override
    public void send(Packet... packets) {
        for (Packet packet : packets) {
            refuseAfterSuspend();
            trace("> ", packet);
            try {
                link.write(packet.bytes());
            } catch (IOException e) {
                throw new LinkLost("connection lost: " + e.getMessage(), e);
            }
            sentNanos = time.nanos();
        }
    }

    /** Makes no lambda expression for each packet, which costs as much as decoding it. */
    private static void trace(String direction, Packet packet) {
        if (LOG.isLoggable(Level.TRACE)) {
            LOG.log(Level.TRACE, direction + packet);
        }
    }

    /** A robot that its watchdog has stopped would resume its last speed at the next packet. */
    private void refuseAfterSuspend() {
        if (suspend.wasSuspended()) {
            LinkLost cause = new LinkLost("connection lost: this computer was asleep");
            abort(cause);
            throw cause;
        }
    }

    @Override
    public long sentNanos() {
        return sentNanos;
    }

    @Override
    public @Nullable LinkLost end() {
        return end;
    }

    /** The first bytes received. */
    FirstBytes firstBytes() {
        return firstBytes;
    }

    /** Counts of packets and damaged bytes. */
    PacketCounts counts() {
        return decoder.counts();
    }

    @Override
    public boolean isFast() {
        return baud > BaudRates.POWER_UP || !isSerial();
    }

    @Override
    public boolean carriesScans() {
        return !isSerial();
    }

    private boolean isSerial() {
        return link.address().startsWith("serial:");
    }

    /**
     * Changes the speed of a serial line.
     *
     * @return false if it is no serial line
     * @throws LinkLost if the port refuses it
     */
    boolean setBaud(int baud) {
        try {
            this.baud = baud;
            return link.setBaud(baud);
        } catch (IOException e) {
            throw new LinkLost("connection lost: " + e.getMessage(), e);
        }
    }

    /** The address as a user would type it. */
    String address() {
        return link.address();
    }

    /** Ends the line after everything was sent. */
    void close() {
        link.close();
    }

    @Override
    public void abort(LinkLost cause) {
        end(cause);
        link.abort();
    }

    /** Keeps the first cause. */
    private synchronized LinkLost end(LinkLost cause) {
        LinkLost first = end == null ? cause : end;
        end = first;
        return first;
    }
}
