package majic.pioneer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.BooleanSupplier;
import majic.TestClock;
import majic.link.Links;
import majic.link.Traffic;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The robot's end of a line over a real socket, on a stepped clock: time advances when the driver waits and has handled all
 * that was sent to it. Packets in both directions may have a latency. Everything runs on the clock's thread.
 */
public final class SteppedPeer implements AutoCloseable {
    private final ServerSocketChannel server;
    private final String address;
    private final Robot robot;
    private final long latencyNanos;
    private final Queue<Due> underWay = new ArrayDeque<>();
    private final TestClock clock;
    private final Signal news;
    private FrameDecoder decoder = new FrameDecoder();
    private @Nullable SocketChannel client;
    private String clientAddress = "";
    private long heldUntilNanos;
    volatile long endMs;
    volatile boolean endedHard;
    private long sent;
    private long received;
    private long nanos;

    private record Due(long atNanos, Runnable event) {}

    /** The behaviour of the robot's end. */
    interface Robot {
        /** A client connected. */
        default void connected(SteppedPeer line) {}

        /** A packet came. */
        void received(SteppedPeer line, Packet packet);

        /** A millisecond has passed. */
        default void step(SteppedPeer line) {}

        /** The client has disconnected. */
        default void left() {}
    }

    SteppedPeer(Robot robot) {
        this(robot, 0);
    }

    /**
     * Listens on a free port of loopback.
     *
     * @param latencyMs of packets in either direction
     */
    SteppedPeer(Robot robot, int latencyMs) {
        this.robot = robot;
        this.latencyNanos = latencyMs * 1_000_000L;
        try {
            server = ServerSocketChannel.open().bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            server.configureBlocking(false);
            address = "127.0.0.1:" + ((InetSocketAddress) server.getLocalAddress()).getPort();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        clock = new TestClock(this::step, this::isQuiet);
        news = clock.time().signal();
    }

    /** As a user would type it after {@code pioneer:}. */
    String address() {
        return "//" + address;
    }

    /** As the driver sees this end. */
    String where() {
        return address;
    }

    public TimeSource time() {
        return clock.time();
    }

    /** Milliseconds since the start. */
    long millis() {
        return nanos / 1_000_000;
    }

    /** Waits on the clock, testing the condition whenever a packet came or was sent. */
    public boolean await(BooleanSupplier condition, double seconds) {
        try {
            return news.await(condition, seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Wakes the waiting thread to test its condition again. */
    void raise() {
        news.raise();
    }

    /** Waits for a time on the clock. */
    public void pass(double seconds) {
        await(() -> false, seconds);
    }

    /** Sends bytes, to arrive after the latency. */
    void send(byte[] bytes) {
        underWay.add(new Due(nanos + latencyNanos, () -> deliver(bytes)));
    }

    /** Delays all packets in both directions, and then delivers them at once. */
    void hold(double seconds) {
        heldUntilNanos = nanos + (long) (seconds * 1e9);
    }

    public void hangUp() {
        SocketChannel open = client;
        client = null;
        clientAddress = "";
        if (open != null) {
            close(open);
        }
    }

    private boolean isQuiet() {
        try {
            accept();
            read();
        } catch (IOException e) {
            endedHard = true;
            leave();
        }
        return Links.traffic().stream()
                .filter(traffic -> traffic.open() && traffic.remote().equals(address))
                .allMatch(this::isThrough);
    }

    private boolean isThrough(Traffic traffic) {
        return traffic.local().equals(clientAddress) && traffic.written() == received && traffic.consumed() == sent;
    }

    private void accept() throws IOException {
        SocketChannel coming = server.isOpen() ? server.accept() : null;
        if (coming == null) {
            return;
        }
        hangUp();
        coming.configureBlocking(false);
        coming.setOption(StandardSocketOptions.TCP_NODELAY, true);
        InetSocketAddress from = (InetSocketAddress) coming.getRemoteAddress();
        clientAddress = from.getAddress().getHostAddress() + ":" + from.getPort();
        client = coming;
        sent = 0;
        received = 0;
        underWay.clear();
        decoder = new FrameDecoder();
        robot.connected(this);
    }

    private void read() throws IOException {
        SocketChannel open = client;
        ByteBuffer chunk = ByteBuffer.allocate(4096);
        int count = open == null ? 0 : open.read(chunk);
        if (count < 0) {
            leave();
        } else if (count > 0) {
            received += count;
            decoder.feed(
                    chunk.array(),
                    count,
                    packet -> underWay.add(new Due(nanos + latencyNanos, () -> robot.received(this, packet))));
        }
    }

    private void leave() {
        endMs = millis();
        hangUp();
        robot.left();
        news.raise();
    }

    private void step(long nowNanos) {
        nanos = nowNanos;
        robot.step(this);
        boolean moved = false;
        while (nanos >= heldUntilNanos && !underWay.isEmpty() && underWay.peek().atNanos <= nanos) {
            underWay.remove().event.run();
            moved = true;
        }
        if (moved) {
            news.raise();
        }
    }

    private void deliver(byte[] bytes) {
        SocketChannel open = client;
        ByteBuffer left = ByteBuffer.wrap(bytes);
        try {
            while (open != null && left.hasRemaining()) {
                sent += open.write(left);
            }
        } catch (IOException e) {
            leave();
        }
    }

    private static void close(SocketChannel open) {
        try {
            open.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        clock.close();
        try {
            server.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
