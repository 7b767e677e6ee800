package majicsim.net;

import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicLong;

/**
 * What the lines of all ports share: the bytes on their way in both directions, the counters, and the ending. Guarded by the lab's lock, but for the counters. A
 * subclass writes bytes.
 */
abstract class RobotLine implements Line {
    private static final System.Logger LOG = System.getLogger(RobotLine.class.getName());

    private final String robot;
    private final String peer;
    private final Wiring wiring;
    private final DelayedBytes out;
    private final DelayedBytes in;
    private final AtomicLong consumed = new AtomicLong();
    private final AtomicLong written = new AtomicLong();
    private volatile Ending ending = Ending.NONE;

    /** With {@code jitters}, each exchange takes as long as the faults' jitter is. */
    RobotLine(String robot, String peer, Wiring wiring, boolean jitters) {
        this.robot = robot;
        this.peer = peer;
        this.wiring = wiring;
        this.out = new DelayedBytes(wiring.faults(), jitters, this::writeCounted);
        this.in = new DelayedBytes(wiring.faults(), jitters, this::deliver);
    }

    /** Gives bytes to the client without blocking, and returns how many it took or keeps for later; the others are lost. */
    abstract int write(byte[] bytes);

    /** Whether everything given to {@link #write} has left. */
    abstract boolean isFlushed();

    @Override
    public final String peer() {
        return peer;
    }

    @Override
    public final void send(byte[] message) {
        if (isOpen() && message.length > 0) {
            out.enter(message);
        }
    }

    @Override
    public void close() {
        if (isOpen()) {
            ending = Ending.BY_ROBOT;
        }
    }

    @Override
    public final boolean isOpen() {
        return ending == Ending.NONE;
    }

    /**
     * Hands bytes to the firmware, or keeps them for later; the reader's thread, without the lock. A failure of the firmware is logged,
     * and the line stays open.
     */
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

    final void clientLeft() {
        if (ending != Ending.CUT) {
            ending = Ending.BY_CLIENT;
        }
        out.clear();
    }

    /** A client waits for the place of one that has left: what is still kept from that one is delivered now. */
    final void deliverAllIfClientLeft() {
        if (ending == Ending.BY_CLIENT) {
            in.releaseAll();
        }
    }

    final void cut() {
        ending = Ending.CUT;
        discardPending();
    }

    final void discardPending() {
        out.clear();
        in.clear();
    }

    final boolean isCut() {
        return ending == Ending.CUT;
    }

    /** Whether nothing more can happen on this line. */
    final boolean isOver() {
        return switch (ending) {
            case NONE -> false;
            case BY_ROBOT -> out.isEmpty() && isFlushed();
            case BY_CLIENT -> in.isEmpty();
            case CUT -> true;
        };
    }

    final LineCount count() {
        boolean delivers = isOpen() || (ending == Ending.BY_ROBOT && !out.isEmpty());
        return new LineCount(
                robot,
                peer,
                consumed.get(),
                written.get(),
                delivers,
                !wiring.faults().isReading());
    }

    private void deliver(byte[] bytes) {
        if (ending == Ending.NONE || ending == Ending.BY_CLIENT) {
            wiring.firmware().received(this, bytes);
        }
    }

    private void writeCounted(byte[] bytes) {
        written.addAndGet(bytes.length);
        int lost = bytes.length - write(bytes);
        written.addAndGet(-lost);
    }
}
