package majic.time;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;

/** The system's monotonic clock. */
final class SystemTime implements TimeSource {
    static final SystemTime INSTANCE = new SystemTime();

    private static final Membership NO_MEMBERSHIP = () -> {};

    private SystemTime() {}

    @Override
    public long nanos() {
        return System.nanoTime();
    }

    @Override
    public Signal signal() {
        return new SystemSignal();
    }

    @Override
    public Thread thread(String name, Runnable body) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public Membership join() {
        return NO_MEMBERSHIP;
    }

    /** Counts how often it was raised, so that a raise between looking and waiting is not lost. */
    private static final class SystemSignal implements Signal {
        private final ReentrantLock lock = new ReentrantLock();
        private final Condition raised = lock.newCondition();
        private long raises;

        @Override
        public boolean await(BooleanSupplier condition, double seconds) throws InterruptedException {
            long deadline = seconds == FOR_EVER ? Long.MAX_VALUE : System.nanoTime() + (long) Math.ceil(seconds * 1e9);
            while (true) {
                long seen = raises();
                if (condition.getAsBoolean()) {
                    return true;
                }
                if (!pause(seen, deadline)) {
                    return condition.getAsBoolean();
                }
            }
        }

        @Override
        public void raise() {
            lock.lock();
            try {
                raises++;
                raised.signalAll();
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

        /** Waits for the next raise; false when the deadline came first. */
        private boolean pause(long seen, long deadline) throws InterruptedException {
            lock.lockInterruptibly();
            try {
                while (raises == seen) {
                    if (deadline == Long.MAX_VALUE) {
                        raised.await();
                    } else if (raised.awaitNanos(deadline - System.nanoTime()) <= 0) {
                        return raises != seen;
                    }
                }
                return true;
            } finally {
                lock.unlock();
            }
        }
    }
}
