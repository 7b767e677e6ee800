package majic.link;

import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/** Counts the traffic of one link, and tracks whether it is open. */
final class TrafficCounter {
    private final AtomicLong written = new AtomicLong();
    private final AtomicLong consumed = new AtomicLong();
    private long handedOut;
    private volatile boolean open;
    private volatile boolean ending;
    private volatile @Nullable Thread reader;

    void opened() {
        open = true;
    }

    /** Called before bytes are sent, so that they cannot arrive uncounted. */
    void writing(int bytes) {
        written.addAndGet(bytes);
    }

    /** Called on the reader thread when it reads again: earlier bytes are handled. */
    void readerIsBack() {
        reader = Thread.currentThread();
        consumed.set(handedOut);
    }

    void handedOut(int bytes) {
        handedOut += bytes;
    }

    /** Called on the reader thread at the end of the link, which that thread has yet to handle. */
    void readerAtEnd() {
        ending = true;
    }

    /**
     * Called on the thread that closes the link. On the reader thread the link counts as open until that thread ends.
     */
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
