package majic.drivertest;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Queue;
import majic.link.Links;
import majic.link.Traffic;
import org.jspecify.annotations.Nullable;

/**
 * The robot's end of a connection over a real socket, on a stepped clock: time advances by 1 ms when every thread that
 * uses the clock waits and all bytes have been processed at both ends. Bytes in both directions may have a latency.
 *
 * <p>It has one client at a time: a new connection ends the one before, or is refused. The methods of its {@link Robot}
 * are called one at a time, on the clock's thread or on one that calls a method of the peer; they must not wait.
 */
public final class ScriptedPeer implements AutoCloseable {
    private static final int CHUNK = 4096;
    private static final long NANOS_PER_MS = 1_000_000;

    private final ServerSocketChannel server;
    private final String address;
    private final Robot robot;
    private final long latencyNanos;
    private final Queue<Due> underWay = new ArrayDeque<>();
    private final TestClock clock;
    private @Nullable SocketChannel client;
    private String clientAddress = "";
    private boolean refusesFurther;
    private long heldUntilNanos;
    private long sent;
    private long received;
    private volatile long nanos;

    /** What arrives at either end, and when. */
    private record Due(long atNanos, Runnable arrival) {}

    /** The behaviour of the robot. */
    @FunctionalInterface
    public interface Robot {
        /**
         * Handles bytes from the driver.
         *
         * @param peer for the replies
         * @param bytes at least one; not necessarily a whole message
         */
        void received(ScriptedPeer peer, byte[] bytes);

        /**
         * Handles a new connection. Does nothing unless overridden.
         *
         * @param peer for a greeting
         */
        default void connected(ScriptedPeer peer) {}

        /**
         * Does what the robot does in one millisecond. Does nothing unless overridden.
         *
         * @param peer for reports
         */
        default void step(ScriptedPeer peer) {}

        /**
         * Handles the end of the connection by the driver. Does nothing unless overridden.
         *
         * @param reset whether it ended by an error, such as unread bytes, and not by an orderly close
         */
        default void left(boolean reset) {}
    }

    /**
     * Listens at a free port of this computer. The calling thread uses the clock from now on.
     *
     * @param robot the behaviour
     */
    public ScriptedPeer(Robot robot) {
        this(robot, 0);
    }

    /**
     * Listens at a free port of this computer. The calling thread uses the clock from now on.
     *
     * @param robot the behaviour
     * @param latencyMs the latency of bytes in either direction, ms; 0 or more
     */
    public ScriptedPeer(Robot robot, int latencyMs) {
        this.robot = robot;
        this.latencyNanos = latencyMs * NANOS_PER_MS;
        try {
            server = ServerSocketChannel.open().bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            server.configureBlocking(false);
            address = "127.0.0.1:" + ((InetSocketAddress) server.getLocalAddress()).getPort();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        clock = new TestClock(this::step, this::isQuiet);
    }

    /**
     * Returns where it listens.
     *
     * @return host and port: {@code 127.0.0.1:40312}
     */
    public String address() {
        return address;
    }

    /**
     * Returns the clock, which the driver has to use too.
     *
     * @return the same object at each call
     */
    public TestClock clock() {
        return clock;
    }

    /**
     * Returns the time.
     *
     * @return ms since the peer was created
     */
    public long millis() {
        return nanos / NANOS_PER_MS;
    }

    /**
     * Sends bytes to the driver; they arrive after the latency. Bytes that are sent without a client are lost.
     *
     * @param bytes the bytes, which must not be changed afterwards
     */
    public synchronized void send(byte[] bytes) {
        underWay.add(new Due(nanos + latencyNanos, () -> deliver(bytes)));
    }

    /**
     * Holds back all bytes in both directions, and then delivers them at once.
     *
     * @param seconds for how long from now
     */
    public synchronized void hold(double seconds) {
        heldUntilNanos = nanos + (long) (seconds * 1e9);
    }

    /** Refuses a new connection from now on while there is one, which goes on. */
    public synchronized void refuseFurther() {
        refusesFurther = true;
    }

    /** Closes the connection, if there is one, as a robot does that is switched off; the next client is accepted. */
    public synchronized void hangUp() {
        SocketChannel open = client;
        client = null;
        clientAddress = "";
        if (open != null) {
            close(open);
        }
    }

    /** Whether all bytes have been processed at both ends; accepts and reads on the way. */
    private synchronized boolean isQuiet() {
        try {
            accept();
        } catch (IOException e) {
            leave(true);
        }
        read();
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
        while (refusesFurther && read()) {
            // The client may have ended its connection before.
        }
        if (refusesFurther && client != null) {
            close(coming);
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
        robot.connected(this);
    }

    /** Reads a part of what has arrived; returns whether there was any. */
    private boolean read() {
        SocketChannel open = client;
        ByteBuffer chunk = ByteBuffer.allocate(CHUNK);
        try {
            int count = open == null ? 0 : open.read(chunk);
            if (count < 0) {
                leave(false);
            } else if (count > 0) {
                received += count;
                byte[] bytes = Arrays.copyOf(chunk.array(), count);
                underWay.add(new Due(nanos + latencyNanos, () -> robot.received(this, bytes)));
            }
            return count > 0;
        } catch (IOException e) {
            leave(true);
            return false;
        }
    }

    private void leave(boolean reset) {
        hangUp();
        robot.left(reset);
    }

    private synchronized void step(long nowNanos) {
        nanos = nowNanos;
        robot.step(this);
        while (nanos >= heldUntilNanos && !underWay.isEmpty() && underWay.peek().atNanos <= nanos) {
            underWay.remove().arrival.run();
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
            leave(true);
        }
    }

    private static void close(SocketChannel open) {
        try {
            open.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Ends the clock and listens no more. Close the driver first. */
    @Override
    public void close() {
        clock.close();
        hangUp();
        try {
            server.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
