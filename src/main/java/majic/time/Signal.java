package majic.time;

import java.util.function.BooleanSupplier;

/**
 * A place where threads wait for something to become true, woken by the thread that may have made it true. Thread-safe.
 */
public interface Signal {
    /** A time that never comes. */
    double FOR_EVER = Double.POSITIVE_INFINITY;

    /**
     * Waits until a condition holds. The condition is looked at on the calling thread, at once and after every
     * {@link #raise}, without any lock held.
     *
     * @param condition what to wait for; quick, and without side effects
     * @param seconds how long at most, on the clock that made this signal; {@link #FOR_EVER} is allowed
     * @return whether the condition held when this returned
     * @throws InterruptedException if the thread is interrupted meanwhile
     * @throws RuntimeException if the clock has ended, as a simulated lab's does by an error in the lab; the message
     *     contains the reason
     */
    boolean await(BooleanSupplier condition, double seconds) throws InterruptedException;

    /** Wakes all threads waiting here to check their condition again. To be called after the change; never blocks. */
    void raise();
}
