package majic.bot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * A clock for tests that does not advance while any of its threads runs, and jumps to the next deadline as soon as all
 * of them wait. A test thread that has joined it decides by its own waits when time passes.
 */
public final class SteppedTime implements TimeSource {
    private final Object lock = new Object();
    private final Set<Thread> members = new HashSet<>();
    private final List<Waiter> waiters = new ArrayList<>();
    private int running;
    private long now = 1_000_000_000L;

    /** A waiting thread; guarded by the lock. */
    private static final class Waiter {
        private final Object place;
        private final long deadline;
        private final boolean counted;
        private boolean woken;

        Waiter(Object place, long deadline, boolean counted) {
            this.place = place;
            this.deadline = deadline;
            this.counted = counted;
        }
    }

    @Override
    public long nanos() {
        synchronized (lock) {
            return now;
        }
    }

    @Override
    public Signal signal() {
        return new SteppedSignal();
    }

    @Override
    public Thread thread(String name, Runnable body) {
        Thread thread = new Thread(name) {
            @Override
            public synchronized void start() {
                enter(this);
                super.start();
            }

            @Override
            public void run() {
                try {
                    body.run();
                } finally {
                    leave(this);
                }
            }
        };
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public Membership join() {
        Thread thread = Thread.currentThread();
        enter(thread);
        return () -> leave(thread);
    }

    private void enter(Thread thread) {
        synchronized (lock) {
            if (members.add(thread)) {
                running++;
            }
        }
    }

    private void leave(Thread thread) {
        synchronized (lock) {
            if (members.remove(thread)) {
                running--;
                step();
            }
        }
    }

    /** Jumps to the next deadline if no thread runs; with the lock held. */
    private void step() {
        long next = waiters.stream().mapToLong(waiter -> waiter.deadline).min().orElse(Long.MAX_VALUE);
        if (running > 0 || next == Long.MAX_VALUE) {
            return;
        }
        now = Math.max(now, next);
        wake(waiter -> waiter.deadline <= now);
    }

    private void wake(Predicate<Waiter> which) {
        for (Waiter waiter : List.copyOf(waiters)) {
            if (which.test(waiter)) {
                remove(waiter);
            }
        }
        lock.notifyAll();
    }

    private void remove(Waiter waiter) {
        waiters.remove(waiter);
        waiter.woken = true;
        running += waiter.counted ? 1 : 0;
    }

    private final class SteppedSignal implements Signal {
        private long raises;

        @Override
        public boolean await(BooleanSupplier condition, double seconds) throws InterruptedException {
            long deadline = seconds == FOR_EVER ? Long.MAX_VALUE : nanos() + (long) (seconds * 1e9);
            while (true) {
                long seen = raises();
                if (condition.getAsBoolean()) {
                    return true;
                }
                if (nanos() >= deadline) {
                    return false;
                }
                pause(seen, deadline);
            }
        }

        @Override
        public void raise() {
            synchronized (lock) {
                raises++;
                wake(waiter -> waiter.place == this);
            }
        }

        private long raises() {
            synchronized (lock) {
                return raises;
            }
        }

        private void pause(long seen, long deadline) throws InterruptedException {
            synchronized (lock) {
                if (raises != seen) {
                    return;
                }
                Waiter waiter = new Waiter(this, deadline, members.contains(Thread.currentThread()));
                waiters.add(waiter);
                running -= waiter.counted ? 1 : 0;
                step();
                try {
                    while (!waiter.woken) {
                        lock.wait();
                    }
                } catch (InterruptedException e) {
                    if (!waiter.woken) {
                        remove(waiter);
                    }
                    throw e;
                }
            }
        }
    }
}
