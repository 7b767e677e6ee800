package majic.link;

import java.util.concurrent.atomic.AtomicLong;

/** Counts the traffic of one link. */
final class Counter {
    private final AtomicLong written = new AtomicLong();
    private final AtomicLong consumed = new AtomicLong();
    private long handedOut;
    private volatile boolean open;

    void opened() {
        open = true;
    }

    /** Called before the bytes go out, so that they are never seen arriving uncounted. */
    void writing(int bytes) {
        written.addAndGet(bytes);
    }

    /** Called on the reader's thread when it comes for more: what it had is dealt with. */
    void readerIsBack() {
        consumed.set(handedOut);
    }

    void handedOut(int bytes) {
        handedOut += bytes;
    }

    void ended() {
        open = false;
    }

    Traffic traffic(String local, String remote) {
        return new Traffic(local, remote, written.get(), consumed.get(), open);
    }
}
