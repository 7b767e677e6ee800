package majic.mavlink.line;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.driver.FirstBytes;
import majic.mavlink.frame.FrameCounts;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.message.VehicleHeartbeat;

/** The part of one robot in a connection that it may share with others. Thread-safe. */
public final class VehicleLine implements AutoCloseable {
    private final SharedLine line;
    private final FrameListener listener;
    private final Runnable leave;
    private final AtomicBoolean left = new AtomicBoolean();

    VehicleLine(SharedLine line, FrameListener listener, Runnable leave) {
        this.line = line;
        this.listener = listener;
        this.leave = leave;
    }

    /**
     * Sends to a vehicle, in its version of the protocol; takes no longer than the write deadline of the link.
     *
     * @param system the vehicle
     * @param message what to send
     * @throws IOException if the connection has ended
     */
    public void send(int system, OutgoingMessage message) throws IOException {
        failIfEnded();
        line.send(system, message);
    }

    /**
     * Sends to everything that has sent a frame.
     *
     * @throws IOException if the connection has ended
     */
    public void sendToAll(OutgoingMessage message) throws IOException {
        failIfEnded();
        line.sendToAll(message);
    }

    private void failIfEnded() throws IOException {
        IOException cause = line.cause();
        if (cause != null) {
            throw new IOException(cause.getMessage(), cause);
        }
        if (left.get()) {
            throw new IOException("the connection is closed");
        }
    }

    /**
     * Returns the vehicles that have sent a heartbeat on this connection within the last 3 s.
     *
     * @return the newest heartbeats by their systems, in order
     */
    public Map<Integer, VehicleHeartbeat> autopilots() {
        return line.autopilots();
    }

    /**
     * Returns the first bytes that have arrived, from which another protocol can be recognised.
     *
     * @return since the connection was opened
     */
    public FirstBytes firstBytes() {
        return line.firstBytes();
    }

    /**
     * Returns what has arrived where a vehicle is.
     *
     * @param system the vehicle
     * @return since the connection was opened
     */
    public FrameCounts counts(int system) {
        return line.counts(system);
    }

    /** Leaves the connection, which its last user closes. Does nothing the second time. */
    @Override
    public void close() {
        if (left.compareAndSet(false, true)) {
            line.remove(listener);
            leave.run();
        }
    }
}
