package majic.time;

import java.util.function.BooleanSupplier;

/** Lets threads wait until a condition holds; a thread that may have made it true wakes them. Thread-safe. */
public interface Signal {
    /** No time limit. */
    double FOR_EVER = Double.POSITIVE_INFINITY;

    /**
     * Waits until a condition holds. The condition is evaluated on the calling thread, at once and after every
     * {@link #raise}, without any lock held.
     *
     * @param condition must be quick and have no side effects
     * @param seconds time limit on the clock that made this signal; {@link #FOR_EVER} for none
     * @return whether the condition holds
     * @throws InterruptedException if the thread is interrupted meanwhile
     * @throws RuntimeException if the clock has ended, as that of a simulated lab does after an error in the lab; the
     *     message contains the reason
     */
    boolean await(BooleanSupplier condition, double seconds) throws InterruptedException;

    /** Wakes all waiting threads, which check their conditions again. Must be called after the change; never blocks. */
    void raise();
}
