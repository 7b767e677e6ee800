package majic.time;

import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;

/**
 * A signal that counts how often it is raised, so that a raise between the check of a condition and the wait is not
 * lost. A clock adds how its threads wait and wake. Thread-safe.
 */
public abstract class CountingSignal implements Signal {
    /** Guards the count; a clock that must wake and count its threads at the same moment passes its own lock. */
    protected final ReentrantLock lock;

    private long raises;

    /**
     * Creates a signal that was never raised.
     *
     * @param lock guards the count; held while {@link #pause} and {@link #wakeAll} are called
     */
    protected CountingSignal(ReentrantLock lock) {
        this.lock = lock;
    }

    /**
     * Returns the time of the clock.
     *
     * @return nanoseconds, never going back
     */
    protected abstract long nanos();

    /**
     * Waits until the signal is raised or the deadline is reached. May return earlier. Must release the lock while it
     * waits.
     *
     * @param deadlineNanos time of the clock; {@link Long#MAX_VALUE} for no deadline
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    protected abstract void pause(long deadlineNanos) throws InterruptedException;

    /** Ends all pauses. */
    protected abstract void wakeAll();

    @Override
    public final boolean await(BooleanSupplier condition, double seconds) throws InterruptedException {
        long deadline = seconds == FOR_EVER ? Long.MAX_VALUE : nanos() + (long) Math.ceil(seconds * 1e9);
        while (true) {
            long seen = raises();
            if (condition.getAsBoolean()) {
                return true;
            }
            if (nanos() >= deadline) {
                return false;
            }
            pauseUnlessRaised(seen, deadline);
        }
    }

    @Override
    public final void raise() {
        lock.lock();
        try {
            raises++;
            wakeAll();
        } finally {
            lock.unlock();
        }
    }

    private long raises() {
        lock.lock();
        try {
            return raises;
        } finally {
            lock.unlock();
        }
    }

    private void pauseUnlessRaised(long seen, long deadline) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            if (raises == seen) {
                pause(deadline);
            }
        } finally {
            lock.unlock();
        }
    }
}
