package majic.link;

import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/** Counts the traffic of one link. */
final class Counter {
    private final AtomicLong written = new AtomicLong();
    private final AtomicLong consumed = new AtomicLong();
    private long handedOut;
    private volatile boolean open;
    private volatile boolean ending;
    private volatile @Nullable Thread reader;

    void opened() {
        open = true;
    }

    /** Called before the bytes go out, so that they are never seen arriving uncounted. */
    void writing(int bytes) {
        written.addAndGet(bytes);
    }

    /** Called on the reader's thread when it comes for more: what it had is dealt with. */
    void readerIsBack() {
        reader = Thread.currentThread();
        consumed.set(handedOut);
    }

    void handedOut(int bytes) {
        handedOut += bytes;
    }

    /** Called on the reader's thread when it sees the end. What follows from that, this thread has yet to do. */
    void readerSawTheEnd() {
        ending = true;
    }

    /** Called on whatever thread closes the link. A reader that saw the end has more to do than that. */
    void closed() {
        if (!ending || Thread.currentThread() != reader) {
            open = false;
        }
    }

    private boolean isOpen() {
        Thread last = reader;
        boolean over = ending && (last == null || !last.isAlive());
        return open && !over;
    }

    Traffic traffic(String local, String remote) {
        return new Traffic(local, remote, written.get(), consumed.get(), isOpen());
    }
}
