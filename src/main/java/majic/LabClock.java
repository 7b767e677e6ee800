package majic;

import java.util.Comparator;
import java.util.HashSet;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import majic.bot.Signal;
import majic.bot.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The clock of a simulated lab, which everybody who commands its robots waits on. It takes one step of the lab after
 * another, as its {@link Pacing} allows: against the wall clock, or as soon as nobody has anything left to do.
 *
 * <p>Threads made by {@link #thread} and those that {@link #join} are members: a stepped clock stands still while one of
 * them runs, and goes on when all of them wait at a {@link Signal}. Who wakes a member counts it as running before it
 * does, so the clock cannot slip in between.
 */
final class LabClock implements TimeSource, AutoCloseable {
    private final Steps lab;
    private final Pacing pacing;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition membersWait = lock.newCondition();
    private final PriorityQueue<Waiter> sleepers = new PriorityQueue<>(Comparator.comparingLong(w -> w.deadline));
    private final ThreadLocal<Boolean> membership = ThreadLocal.withInitial(() -> false);
    private volatile long nowNanos;
    private int running;
    private long awakenings;
    private volatile boolean closed;

    /** What the clock moves on: the lab. */
    interface Steps {
        /** Moves the lab on by one step. */
        void step();

        /**
         * The lab's time.
         *
         * @return nanoseconds since its start
         */
        long nanos();
    }

    LabClock(Steps lab, Pacing pacing) {
        this.lab = lab;
        this.pacing = pacing;
    }

    void start() {
        Thread stepper = new Thread(this::run, "lab clock");
        stepper.setDaemon(true);
        stepper.start();
    }

    @Override
    public void close() {
        closed = true;
        lock.lock();
        try {
            membersWait.signalAll();
        } finally {
            lock.unlock();
        }
    }

    @Override
    public long nanos() {
        return nowNanos;
    }

    @Override
    public Signal signal() {
        return new LabSignal();
    }

    @Override
    public Thread thread(String name, Runnable body) {
        enter();
        Thread thread = new Thread(
                () -> {
                    membership.set(true);
                    try {
                        body.run();
                    } finally {
                        leave();
                    }
                },
                name);
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public Membership join() {
        boolean before = membership.get();
        if (before) {
            return () -> {};
        }
        enter();
        membership.set(true);
        return () -> {
            membership.set(false);
            leave();
        };
    }

    private void enter() {
        lock.lock();
        try {
            running++;
            awakenings++;
        } finally {
            lock.unlock();
        }
    }

    private void leave() {
        lock.lock();
        try {
            running--;
            membersWait.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void run() {
        try {
            while (!closed) {
                long seen = awaitMembers();
                if (pacing.mayStep(nowNanos) && !closed) {
                    stepUnlessAwake(seen);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits until all members wait, and one of them for a time to come; tells how often any was woken before that. */
    private long awaitMembers() throws InterruptedException {
        lock.lockInterruptibly();
        try {
            while (pacing.awaitsMembers() && (running > 0 || sleepers.isEmpty()) && !closed) {
                membersWait.await();
            }
            return awakenings;
        } finally {
            lock.unlock();
        }
    }

    private void stepUnlessAwake(long seen) {
        if (pacing.awaitsMembers() && somebodyWoke(seen)) {
            return;
        }
        lab.step();
        nowNanos = lab.nanos();
        lock.lock();
        try {
            for (Waiter next = sleepers.peek(); next != null && next.deadline <= nowNanos; next = sleepers.peek()) {
                wake(next);
            }
        } finally {
            lock.unlock();
        }
    }

    private boolean somebodyWoke(long seen) {
        lock.lock();
        try {
            return running > 0 || awakenings != seen;
        } finally {
            lock.unlock();
        }
    }

    private void wake(Waiter waiter) {
        if (waiter.woken) {
            return;
        }
        waiter.woken = true;
        sleepers.remove(waiter);
        if (waiter.member) {
            running++;
            awakenings++;
        }
        waiter.wakeUp.signal();
    }

    /** One thread waiting once. Guarded by the clock's lock. */
    private final class Waiter {
        private final long deadline;
        private final boolean member = membership.get();
        private final Condition wakeUp = lock.newCondition();
        private boolean woken;

        Waiter(long deadline) {
            this.deadline = deadline;
        }
    }

    /** Waits on the lab's time. */
    private final class LabSignal implements Signal {
        private final Set<Waiter> waiters = new HashSet<>();
        private long raises;

        @Override
        public boolean await(BooleanSupplier condition, double seconds) throws InterruptedException {
            long deadline = seconds == FOR_EVER ? Long.MAX_VALUE : nowNanos + (long) Math.ceil(seconds * 1e9);
            while (true) {
                long seen = raises();
                if (condition.getAsBoolean()) {
                    return true;
                }
                if (nowNanos >= deadline) {
                    return false;
                }
                pause(seen, deadline);
            }
        }

        @Override
        public void raise() {
            lock.lock();
            try {
                raises++;
                waiters.forEach(LabClock.this::wake);
                waiters.clear();
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

        private void pause(long seen, long deadline) throws InterruptedException {
            lock.lockInterruptibly();
            @Nullable Waiter waiter = null;
            try {
                if (raises != seen) {
                    return;
                }
                waiter = new Waiter(deadline);
                fallAsleep(waiter);
                while (!waiter.woken) {
                    waiter.wakeUp.await();
                }
            } finally {
                if (waiter != null) {
                    wake(waiter);
                    waiters.remove(waiter);
                }
                lock.unlock();
            }
        }

        private void fallAsleep(Waiter waiter) {
            waiters.add(waiter);
            if (waiter.deadline != Long.MAX_VALUE) {
                sleepers.add(waiter);
            }
            if (waiter.member) {
                running--;
            }
            membersWait.signalAll();
        }
    }
}
