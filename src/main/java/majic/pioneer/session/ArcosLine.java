package majic.pioneer.session;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HexFormat;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One connection's packets: those to the robot, each in one write, from any thread; those from it on the reader's thread,
 * one after the other. Ends once, in the reader.
 */
public final class ArcosLine {
    private static final Logger LOG = System.getLogger(ArcosLine.class.getName());
    private static final int OPEN_TIMEOUT_MS = 5000;

    /** A packet whose rest has not come after so long will not become whole (ARCOS sheet 14.1), seconds. */
    private static final double FRAGMENT_S = 0.3;

    private final Link link;
    private final TimeSource time;
    private final FrameDecoder decoder = new FrameDecoder();
    private final FirstBytes firstWords = new FirstBytes();
    private final SuspendDetector slumber = new SuspendDetector();
    private volatile int baud = BaudRates.POWER_UP;
    private volatile long sentNanos;
    private volatile @Nullable LinkLost end;

    /** Who hears of a line. */
    interface Listener {
        /** A packet came. Quick, and never waiting on the clock. */
        void received(Packet packet);

        /** The line is dead, for good. */
        void ended(LinkLost cause);
    }

    public ArcosLine(Link link, TimeSource time) {
        this.link = link;
        this.time = time;
    }

    /**
     * Opens the link and starts reading.
     *
     * @throws BotException if it cannot be opened; the message says why
     */
    void open(Listener listener) {
        try {
            link.open(OPEN_TIMEOUT_MS);
        } catch (IOException e) {
            throw new BotException(String.valueOf(e.getMessage()), e);
        }
        new LinkReader<>(link, "the robot closed it", new Packets(listener)).start("pioneer reader " + link.address());
    }

    /** What the robot sends. */
    private final class Packets implements LinkHandler<Packet> {
        private final Listener listener;
        private long lastNanos = time.nanos();

        Packets(Listener listener) {
            this.listener = listener;
        }

        @Override
        public void decode(byte[] bytes, int count, Consumer<Packet> messages) {
            if (time.secondsSince(lastNanos) > FRAGMENT_S) {
                decoder.dropFragment(messages);
            }
            lastNanos = time.nanos();
            firstWords.heard(bytes, count);
            decoder.feed(bytes, count, messages);
        }

        @Override
        public void received(Packet packet) {
            LOG.log(Level.TRACE, () -> "< " + packet);
            listener.received(packet);
        }

        @Override
        public void ended(IOException cause) {
            LinkLost first = end(new LinkLost("connection lost: " + cause.getMessage(), cause));
            link.close();
            listener.ended(first);
        }
    }

    /**
     * Sends packets, each in a write of its own.
     *
     * @throws LinkLost if the line is dead, takes nothing for a second, or the computer has slept meanwhile
     */
    void send(byte[]... packets) {
        for (byte[] packet : packets) {
            refuseAfterSlumber();
            LOG.log(Level.TRACE, () -> "> " + HexFormat.of().formatHex(packet));
            try {
                link.write(packet);
            } catch (IOException e) {
                throw new LinkLost("connection lost: " + e.getMessage(), e);
            }
            sentNanos = time.nanos();
        }
    }

    /** A robot that its watchdog has stopped would take up its last speed at the next packet. */
    private void refuseAfterSlumber() {
        if (slumber.isOver()) {
            LinkLost cause = new LinkLost("connection lost: this computer was asleep");
            abort(cause);
            throw cause;
        }
    }

    /** Sends packets if the line still takes any. */
    void sendIfPossible(byte[]... packets) {
        try {
            send(packets);
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, () -> "could not send to " + address() + ": " + e.getMessage());
        }
    }

    /** When the last packet was sent, on the driver's clock; 0 before the first. */
    long sentNanos() {
        return sentNanos;
    }

    /** Why the line is dead; null while it lives. */
    @Nullable
    LinkLost end() {
        return end;
    }

    boolean hasEnded() {
        return end != null;
    }

    /** What came first. */
    FirstBytes firstWords() {
        return firstWords;
    }

    /** How well the robot's bytes have come through. */
    PacketCounts reception() {
        return decoder.reception();
    }

    /** Whether there is room for more than SIPs: not on a serial port as it is after power-up (ARCOS sheet 1). */
    boolean isFast() {
        return baud > BaudRates.POWER_UP || !link.address().startsWith("serial:");
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

    /** How a person would write where it leads. */
    String address() {
        return link.address();
    }

    /** Ends the line after what was sent. */
    void close() {
        link.close();
    }

    /** Ends the line at once; what was not delivered yet is thrown away, lest the robot acts on it later. */
    void abort(LinkLost cause) {
        end(cause);
        link.abort();
    }

    /** Only the first cause counts. */
    private synchronized LinkLost end(LinkLost cause) {
        LinkLost first = end == null ? cause : end;
        end = first;
        return first;
    }
}
