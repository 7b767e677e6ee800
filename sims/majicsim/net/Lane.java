package majicsim.net;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * One direction of a line: applies the ordered faults and keeps what is not due yet. Guarded by the lab's lock, but for {@link
 * #isEmpty()}.
 */
final class Lane {
    private final Faults faults;
    private final boolean jitters;
    private final Consumer<byte[]> exit;
    private final ArrayDeque<Piece> shelf = new ArrayDeque<>();
    private volatile boolean empty = true;

    Lane(Faults faults, boolean jitters, Consumer<byte[]> exit) {
        this.faults = faults;
        this.jitters = jitters;
        this.exit = exit;
    }

    void enter(byte[] message) {
        byte[] bytes = faults.garbled(message);
        long due = faults.nowNanos() + faults.drawDelayNanos(jitters);
        if (faults.isHalving() && bytes.length > 1) {
            shelve(due, Arrays.copyOfRange(bytes, 0, bytes.length / 2));
            shelve(due + 1, Arrays.copyOfRange(bytes, bytes.length / 2, bytes.length));
        } else {
            shelve(due, bytes);
        }
        release();
    }

    /** Lets out what is due; during an outage nothing is. */
    void release() {
        while (!shelf.isEmpty() && !faults.isOutage() && shelf.peek().dueNanos() <= faults.nowNanos()) {
            exit.accept(shelf.remove().bytes());
        }
        empty = shelf.isEmpty();
    }

    /** Lets out everything, due or not. */
    void hurry() {
        while (!shelf.isEmpty()) {
            exit.accept(shelf.remove().bytes());
        }
        empty = true;
    }

    /** Whether nothing is kept; may be read without the lock. */
    boolean isEmpty() {
        return empty;
    }

    void clear() {
        shelf.clear();
        empty = true;
    }

    private void shelve(long dueNanos, byte[] bytes) {
        long notBefore =
                shelf.isEmpty() ? dueNanos : Math.max(dueNanos, shelf.getLast().dueNanos());
        empty = false;
        shelf.add(new Piece(notBefore, bytes));
    }

    private record Piece(long dueNanos, byte[] bytes) {}
}
