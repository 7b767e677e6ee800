package majic.time;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

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

    /** A signal whose timeouts are in real time. */
    private static final class SystemSignal extends CountingSignal {
        private final Condition raised = lock.newCondition();

        SystemSignal() {
            super(new ReentrantLock());
        }

        @Override
        protected long nanos() {
            return System.nanoTime();
        }

        @Override
        protected void pause(long deadlineNanos) throws InterruptedException {
            if (deadlineNanos == Long.MAX_VALUE) {
                raised.await();
            } else {
                raised.awaitNanos(deadlineNanos - System.nanoTime());
            }
        }

        @Override
        protected void wakeAll() {
            raised.signalAll();
        }
    }
}
