package majic.time;

/**
 * The clock that drivers, teams, scripts and acts wait and measure by. Against a simulated lab it is the lab's own
 * clock, which may run fast or step; otherwise it is the system's. A thread that waits in any other way does not
 * follow that time, and a stepped clock does not take it into account.
 *
 * <p>Safe for use from several threads.
 */
public interface TimeSource {

    /**
     * The system's own clock.
     *
     * @return the clock of every robot that is not simulated
     */
    static TimeSource system() {
        return SystemTime.INSTANCE;
    }

    /**
     * The time now, since some fixed moment.
     *
     * @return nanoseconds, never going back
     */
    long nanos();

    /**
     * Makes a place to wait at.
     *
     * @return a new signal on this clock
     */
    Signal signal();

    /**
     * Creates a daemon thread that uses this clock: a stepped clock does not advance while it runs, and advances when
     * it waits. The caller starts it; it counts as running from then on.
     *
     * @param name what a thread dump shows
     * @param body what it does
     * @return the thread, not yet started
     */
    Thread thread(String name, Runnable body);

    /**
     * Does something on a daemon thread of its own that lives by this clock. When the system has no thread left, the
     * caller does it, since a robot that is to be stopped cannot wait until there is one.
     *
     * @param name what a thread dump shows
     * @param body what to do
     */
    default void aside(String name, Runnable body) {
        if (!begin(name, body)) {
            body.run();
        }
    }

    /**
     * Does something on a daemon thread of its own that lives by this clock, if the system has a thread left.
     *
     * @param name what a thread dump shows
     * @param body what to do
     * @return whether it was begun; if not, nothing has happened
     */
    default boolean begin(String name, Runnable body) {
        try {
            thread(name, body).start();
            return true;
        } catch (OutOfMemoryError e) {
            return false;
        }
    }

    /**
     * Takes the calling thread into this clock as {@link #thread} does, for a thread that exists already.
     *
     * @return closing it, on the same thread, leaves the clock
     */
    Membership join();

    /** The time a thread spends under a clock. */
    interface Membership extends AutoCloseable {
        @Override
        void close();
    }

    /**
     * Waits.
     *
     * @param seconds how long; zero or less returns at once
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    default void sleep(double seconds) throws InterruptedException {
        signal().await(() -> false, seconds);
    }

    /**
     * The time passed since an earlier moment.
     *
     * @param earlierNanos what {@link #nanos} said then
     * @return seconds
     */
    default double secondsSince(long earlierNanos) {
        return (nanos() - earlierNanos) / 1e9;
    }
}
