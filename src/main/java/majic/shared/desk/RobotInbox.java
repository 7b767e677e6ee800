package majic.shared.desk;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * The messages to one robot that the worker of its desk has not handled yet. While there is none, a message may be
 * handled on the thread of the connection without overtaking another one. Thread-safe.
 */
final class RobotInbox {
    private final DeskWorker worker;
    private final AtomicInteger waiting = new AtomicInteger();

    RobotInbox(DeskWorker worker) {
        this.worker = worker;
    }

    /** Returns whether all messages so far have been handled; for the thread that calls {@link #add}. */
    boolean isEmpty() {
        return waiting.get() == 0;
    }

    /**
     * Passes a message to the worker. Called by the thread of the connection only.
     *
     * @return whether there was room
     */
    boolean add(Runnable work) {
        waiting.incrementAndGet();
        boolean taken = worker.submit(() -> {
            try {
                work.run();
            } finally {
                waiting.decrementAndGet();
            }
        });
        if (!taken) {
            waiting.decrementAndGet();
        }
        return taken;
    }
}
