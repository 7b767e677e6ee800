package majicsim.net;

import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicLong;

/**
 * What the lines of all ports share: two lanes, the counters, and the ending. Guarded by the lab's lock, but for the counters. A
 * subclass writes bytes and ends the connection.
 */
abstract class RobotLine implements Line {
    private static final System.Logger LOG = System.getLogger(RobotLine.class.getName());

    private final String peer;
    private final Wiring wiring;
    private final Lane out;
    private final Lane in;
    private final AtomicLong consumed = new AtomicLong();
    private final AtomicLong written = new AtomicLong();
    private volatile boolean open = true;
    private boolean peerLeft;

    RobotLine(String peer, Wiring wiring) {
        this.peer = peer;
        this.wiring = wiring;
        this.out = new Lane(wiring.faults(), this::writeCounted);
        this.in = new Lane(wiring.faults(), this::deliver);
    }

    /** Gives bytes to the client without blocking, and says how many it took or keeps for later; the others are lost. */
    abstract int write(byte[] bytes);

    /** Whether everything given to {@link #write} has left. */
    abstract boolean isFlushed();

    @Override
    public final String peer() {
        return peer;
    }

    @Override
    public final void send(byte[] message) {
        if (open && message.length > 0) {
            out.enter(message);
        }
    }

    @Override
    public void close() {
        open = false;
    }

    @Override
    public final boolean isOpen() {
        return open;
    }

    /** Hands bytes to the firmware, or shelves them; the reader's thread, without the lock. A fault of the firmware is logged, and the
     * line lives on, as would a robot's. */
    final void receive(byte[] bytes) {
        wiring.lock().lock();
        try {
            in.enter(bytes);
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "the simulated robot could not deal with what " + peer + " sent", e);
        } finally {
            wiring.lock().unlock();
        }
        consumed.addAndGet(bytes.length);
    }

    final void release() {
        in.release();
        out.release();
    }

    /** The client has closed its end: what is still shelved from it is delivered first. */
    final void peerLeft() {
        open = false;
        peerLeft = true;
        out.clear();
    }

    /** Somebody waits for the place of a client that has left: what is shelved from it is delivered now. */
    final void hurryIfPeerLeft() {
        if (peerLeft) {
            in.hurry();
        }
    }

    final void cut() {
        open = false;
        peerLeft = true;
        loseWhatIsUnderWay();
    }

    final void loseWhatIsUnderWay() {
        out.clear();
        in.clear();
    }

    /** Whether nothing more can happen on this line. */
    final boolean isOver() {
        return !open && (peerLeft ? in.isEmpty() : out.isEmpty() && isFlushed());
    }

    final LineCount count() {
        return new LineCount(
                peer, consumed.get(), written.get(), open, !wiring.faults().isReading());
    }

    private void deliver(byte[] bytes) {
        if (open || peerLeft) {
            wiring.firmware().received(this, bytes);
        }
    }

    private void writeCounted(byte[] bytes) {
        written.addAndGet(bytes.length);
        int lost = bytes.length - write(bytes);
        written.addAndGet(-lost);
    }
}
