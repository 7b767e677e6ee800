package majic.time;

/**
 * The clock through which drivers, teams, scripts and acts wait and measure time. For a simulated robot it is the clock
 * of its lab, which may run fast or step; otherwise it is the system's. A thread that waits in any other way does not
 * follow this clock, and a stepped clock does not wait for it. Thread-safe.
 */
public interface TimeSource {

    /**
     * Returns the system's monotonic clock.
     *
     * @return the clock of every robot that is not simulated
     */
    static TimeSource system() {
        return SystemTime.INSTANCE;
    }

    /**
     * Returns the present time.
     *
     * @return nanoseconds since an arbitrary moment, never going back
     */
    long nanos();

    /**
     * Creates a signal to wait at.
     *
     * @return a new signal on this clock
     */
    Signal signal();

    /**
     * Creates a daemon thread that uses this clock: a stepped clock does not advance while it runs, and advances when
     * it waits. The caller starts it; it counts as running from then on.
     *
     * @param name of the thread
     * @param body runs on the thread
     * @return the thread, not yet started
     */
    Thread thread(String name, Runnable body);

    /**
     * Runs a task on a new daemon thread that uses this clock. If the system has no thread left, the task runs on the
     * calling thread, since the stop of a robot cannot wait for a free thread.
     *
     * @param name of the thread
     * @param task the task
     */
    default void runAsync(String name, Runnable task) {
        if (!tryRunAsync(name, task)) {
            task.run();
        }
    }

    /**
     * Runs a task on a new daemon thread that uses this clock, if the system has a thread left.
     *
     * @param name of the thread
     * @param task the task
     * @return whether the thread was started; if not, the task does not run
     */
    default boolean tryRunAsync(String name, Runnable task) {
        try {
            thread(name, task).start();
            return true;
        } catch (OutOfMemoryError e) {
            return false;
        }
    }

    /**
     * Makes the calling thread use this clock, as a thread made by {@link #thread} does.
     *
     * @return to be closed on the same thread, which ends the membership
     */
    Membership join();

    /** The use of a clock by a thread that was not made by it. */
    interface Membership extends AutoCloseable {
        @Override
        void close();
    }

    /**
     * Waits for a time.
     *
     * @param seconds how long; zero or less returns at once
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    default void sleep(double seconds) throws InterruptedException {
        signal().await(() -> false, seconds);
    }

    /**
     * Returns the time passed since an earlier moment.
     *
     * @param earlierNanos what {@link #nanos} returned then
     * @return seconds
     */
    default double secondsSince(long earlierNanos) {
        return (nanos() - earlierNanos) / 1e9;
    }
}
