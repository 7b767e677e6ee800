package majicsim.net;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * One direction of a line: applies the ordered faults and keeps what is not due yet. Guarded by the lab's lock, but for
 * {@link #isEmpty()}.
 */
final class DelayedBytes {
    private final Faults faults;
    private final LabTime time;
    private final DueTime robotDue;
    private final boolean jitters;
    private final Consumer<byte[]> exit;
    private final ArrayDeque<Piece> pending = new ArrayDeque<>();
    private long enteredNanos = -1;
    private long jitterNanos;
    private long busyUntilNanos;
    private volatile boolean empty = true;

    DelayedBytes(Wiring wiring, boolean jitters, Consumer<byte[]> exit) {
        this.faults = wiring.faults();
        this.time = faults.time();
        this.robotDue = wiring.due();
        this.jitters = jitters;
        this.exit = exit;
    }

    void enter(byte[] message) {
        byte[] bytes = faults.garbled(message);
        long due = transmittedNanos(bytes.length) + faults.delayNanos() + jitterNanos();
        if (faults.isHalving() && bytes.length > 1) {
            keep(due, Arrays.copyOfRange(bytes, 0, bytes.length / 2));
            keep(due + 1, Arrays.copyOfRange(bytes, bytes.length / 2, bytes.length));
        } else {
            keep(due, bytes);
        }
        release();
    }

    /** Returns when a line of limited bandwidth has carried these bytes, behind those before. */
    private long transmittedNanos(int bytes) {
        long takes = faults.transmissionNanos(bytes);
        if (takes == 0) {
            return time.lineNanos();
        }
        busyUntilNanos = Math.max(busyUntilNanos, time.lineNanos()) + takes;
        return busyUntilNanos;
    }

    /**
     * Returns the jitter of the bytes that enter now. All bytes of one step of the lab have the same, because how many
     * pieces they arrive in depends on the computer.
     */
    private long jitterNanos() {
        if (jitters && enteredNanos != time.lineNanos()) {
            enteredNanos = time.lineNanos();
            jitterNanos = faults.drawJitterNanos();
        }
        return jitterNanos;
    }

    /** Delivers what is due; during an outage nothing is due. */
    void release() {
        if (empty) {
            return;
        }
        while (!pending.isEmpty() && !faults.isOutage() && pending.peek().dueNanos() <= time.lineNanos()) {
            exit.accept(next());
        }
        empty = pending.isEmpty();
        if (!empty) {
            robotDue.atLatest(pending.getFirst().dueNanos());
        }
    }

    /** Removes the next bytes, all that are due at one moment together: one write for the packets of a report cycle. */
    private byte[] next() {
        Piece first = pending.remove();
        byte[] bytes = first.bytes();
        while (!pending.isEmpty() && pending.peek().dueNanos() == first.dueNanos()) {
            byte[] more = pending.remove().bytes();
            int length = bytes.length;
            bytes = Arrays.copyOf(bytes, length + more.length);
            System.arraycopy(more, 0, bytes, length, more.length);
        }
        return bytes;
    }

    /** Delivers everything, due or not. */
    void releaseAll() {
        while (!pending.isEmpty()) {
            exit.accept(pending.remove().bytes());
        }
        empty = true;
    }

    /** Whether nothing is kept; may be called without the lock. */
    boolean isEmpty() {
        return empty;
    }

    void clear() {
        pending.clear();
        empty = true;
    }

    private void keep(long dueNanos, byte[] bytes) {
        long notBefore = pending.isEmpty()
                ? dueNanos
                : Math.max(dueNanos, pending.getLast().dueNanos());
        empty = false;
        pending.add(new Piece(notBefore, bytes));
    }

    private record Piece(long dueNanos, byte[] bytes) {}
}
