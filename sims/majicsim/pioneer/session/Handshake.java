package majicsim.pioneer.session;

import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.packet.PacketWriter;
import org.jspecify.annotations.Nullable;

/**
 * The three SYNCs before a session (ARCOS sheet 4), strictly in order. A packet out of order makes the client start
 * again: the answer is packet 0xFF, and SYNC0 is expected again.
 */
public final class Handshake {
    private static final int LOST_STEP = 0xFF;
    private static final int LAST = 2;
    private static final long PATIENCE_NANOS = 10_000_000_000L;

    private final byte[] introduction;
    private int expected;
    private long nanos;

    /** The introduction answers SYNC2. */
    public Handshake(String robotName, PioneerModel model) {
        introduction = new PacketWriter(LAST)
                .text(robotName)
                .text(model.className())
                .text(model.subclass())
                .toBytes();
    }

    /** Takes a packet's number; returns the answer to send, or null when the handshake was complete before. */
    public byte @Nullable [] answer(int id) {
        if (isComplete()) {
            return null;
        }
        if (id != expected && id != 0) {
            expected = 0;
            return new PacketWriter(LOST_STEP).toBytes();
        }
        expected = id + 1;
        return id == LAST ? introduction : new PacketWriter(id).toBytes();
    }

    boolean isComplete() {
        return expected > LAST;
    }

    /** The time until it is too late for the rest of an incomplete handshake, ns. */
    long restNanos() {
        return PATIENCE_NANOS - nanos;
    }

    /** Lets time pass. Returns true if the handshake took more than 10 s, and then starts it again. */
    boolean step(long stepNanos) {
        if (isComplete()) {
            return false;
        }
        nanos += stepNanos;
        boolean late = nanos >= PATIENCE_NANOS;
        if (late) {
            restart();
        }
        return late;
    }

    /** Waits for SYNC0 again, as a controller on a serial line does after CLOSE. */
    void restart() {
        expected = 0;
        nanos = 0;
    }
}
