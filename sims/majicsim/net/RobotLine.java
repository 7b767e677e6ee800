package majicsim.net;

import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicLong;

/**
 * What the lines of all ports share: the bytes on their way in both directions, the counters, and the end. Guarded by
 * the lab's lock, but for the counters. A subclass writes bytes.
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
    private volatile End ended = End.NONE;

    /** With {@code jitters}, each exchange takes as long as the faults' jitter is. */
    RobotLine(String robot, String peer, Wiring wiring, boolean jitters) {
        this.robot = robot;
        this.peer = peer;
        this.wiring = wiring;
        this.out = new DelayedBytes(wiring, jitters, this::writeCounted);
        this.in = new DelayedBytes(wiring, jitters, this::deliver);
    }

    /**
     * Gives bytes to the client without blocking, and returns how many it took or keeps for later; the others are lost.
     */
    abstract int write(byte[] bytes);

    /** Whether what has just arrived is lost on its way; asked once for each piece, with the lock held. */
    boolean losesArrival() {
        return false;
    }

    /** Whether everything given to {@link #write} has left. */
    abstract boolean isFlushed();

    @Override
    public final String peer() {
        return peer;
    }

    @Override
    public final void send(byte[] message) {
        if (isOpen() && message.length > 0 && wiring.faults().isReachable()) {
            out.enter(message);
        }
    }

    @Override
    public void close() {
        if (isOpen()) {
            ended = End.BY_ROBOT;
        }
    }

    @Override
    public final boolean isOpen() {
        return ended == End.NONE;
    }

    /**
     * Passes bytes to the firmware, or keeps them for later. Called on the reader's thread without the lock. A failure
     * of the firmware is logged, and the line stays open.
     */
    final void receive(byte[] bytes) {
        wiring.lock().lock();
        try {
            if (wiring.faults().isReachable() && !losesArrival()) {
                in.enter(bytes);
            }
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
        if (ended != End.CUT) {
            ended = End.BY_CLIENT;
        }
        out.clear();
    }

    /**
     * A new client waits until the line of the previous one has ended: delivers what is still kept from the previous
     * one.
     */
    final void deliverAllIfClientLeft() {
        if (ended == End.BY_CLIENT) {
            in.releaseAll();
        }
    }

    final void cut() {
        ended = End.CUT;
        discardPending();
    }

    final void discardPending() {
        out.clear();
        in.clear();
    }

    final boolean isCut() {
        return ended == End.CUT;
    }

    /** Whether nothing more can happen on this line. */
    final boolean isOver() {
        return switch (ended) {
            case NONE -> false;
            case BY_ROBOT -> out.isEmpty() && isFlushed();
            case BY_CLIENT -> in.isEmpty();
            case CUT -> true;
        };
    }

    final LineCount count() {
        boolean delivers = isOpen() || (ended == End.BY_ROBOT && !out.isEmpty());
        return new LineCount(
                robot,
                peer,
                consumed.get(),
                written.get(),
                delivers,
                !wiring.faults().isReading());
    }

    private void deliver(byte[] bytes) {
        if (ended == End.NONE || ended == End.BY_CLIENT) {
            wiring.firmware().received(this, bytes);
        }
    }

    private void writeCounted(byte[] bytes) {
        written.addAndGet(bytes.length);
        int lost = bytes.length - write(bytes);
        written.addAndGet(-lost);
    }

    /** Whether a line has ended, and by which end. */
    private enum End {
        /** Not at all: the line is open. */
        NONE,
        /** The firmware closed it; what it sent before still goes out. */
        BY_ROBOT,
        /** The client closed its end; what it sent before is still delivered. */
        BY_CLIENT,
        /** A fault or the port's own end; what is under way is lost. */
        CUT
    }
}
