package majic.pioneer;

import java.util.function.BooleanSupplier;
import majic.drivertest.ScriptedPeer;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.time.Signal;
import majic.time.TimeSource;

/** A {@link ScriptedPeer} that receives packets of the robot's protocol, and on whose events a test can wait. */
public final class SteppedPeer implements AutoCloseable {
    private final Robot robot;
    private final ScriptedPeer line;
    private final Signal news;
    private FrameDecoder decoder = new FrameDecoder();
    private volatile boolean moved;
    volatile long endMs;
    volatile boolean endedHard;

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
        line = new ScriptedPeer(new Packets(), latencyMs);
        news = line.clock().time().signal();
    }

    /** As a user would type it after {@code pioneer:}. */
    String address() {
        return "//" + line.address();
    }

    /** As the driver sees this end. */
    String where() {
        return line.address();
    }

    public TimeSource time() {
        return line.clock().time();
    }

    /** Milliseconds since the start. */
    long millis() {
        return line.millis();
    }

    /** Waits on the clock, testing the condition after each packet that came or was sent. */
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
        line.send(bytes);
        moved = true;
    }

    /** Delays all packets in both directions, and then delivers them at once. */
    void hold(double seconds) {
        line.hold(seconds);
    }

    public void hangUp() {
        line.hangUp();
    }

    @Override
    public void close() {
        line.close();
    }

    /** Decodes the packets and keeps the records of a test. */
    private final class Packets implements ScriptedPeer.Robot {
        @Override
        public void connected(ScriptedPeer peer) {
            decoder = new FrameDecoder();
            robot.connected(SteppedPeer.this);
        }

        @Override
        public void received(ScriptedPeer peer, byte[] bytes) {
            decoder.feed(bytes, bytes.length, packet -> robot.received(SteppedPeer.this, packet));
            moved = true;
        }

        @Override
        public void step(ScriptedPeer peer) {
            boolean raise = moved;
            moved = false;
            robot.step(SteppedPeer.this);
            if (raise) {
                news.raise();
            }
        }

        @Override
        public void left(boolean reset) {
            endMs = line.millis();
            endedHard |= reset;
            robot.left();
            news.raise();
        }
    }
}
