package majic.time;

/**
 * Lets a thread wake up while another thread still prepares work for it, because waking up often takes longer than
 * the preparation. {@link Signal#raise} has to follow {@link #raise} and {@link #meet}. Thread-safe.
 */
public final class Expectation {
    /** About 0.2 ms: an expectation that is not met costs no more. */
    private static final int MOST_YIELDS = 500;

    private volatile boolean raised;
    private volatile boolean met;

    /** Announces work that will follow at once, or not at all. */
    public void raise() {
        met = false;
        raised = true;
    }

    /** Tells that the work is there. */
    public void meet() {
        met = true;
    }

    /**
     * Returns whether work was announced since the last {@link #await}.
     *
     * @return true if the thread should wake up
     */
    public boolean isRaised() {
        return raised;
    }

    /**
     * Waits for announced work without sleeping, for about 0.2 ms at most; leaves the processor to all other threads.
     * Returns at once if none was announced. Takes no lock, which would delay the thread that brings the work.
     */
    public void await() {
        if (raised) {
            raised = false;
            for (int yields = 0; yields < MOST_YIELDS && !met; yields++) {
                Thread.yield();
            }
        }
    }
}
