package majic.lab;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import majic.bot.BotException;
import majic.time.CountingSignal;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The clock of a simulated lab, on which all threads that command its robots wait. Takes one step of the lab after
 * another, as its {@link Pacing} allows: at the pace of the wall clock, or as soon as all members wait.
 *
 * <p>Threads made by {@link #thread} and those that {@link #join} are members: a stepped clock does not advance while
 * one of them runs, and advances when all of them wait at a {@link Signal}. Members that have been raised, or whose
 * time has come, wake one after another, each when no other runs and no byte is in transit. So a run does not depend on
 * which thread the computer happens to run first. If a member runs on for 250 ms of real time, because it computes or
 * waits in another way, the others wake beside it.
 *
 * <p>A clock ends when a step of its lab throws, and a stepped one also when it has not advanced for 10 s of real time
 * although a thread waits for a later time and no member has used the processor. Every wait then throws a
 * {@link BotException} that gives the reason.
 *
 * <p>A closed clock takes no more steps, and its time goes on at the pace of the system's clock, so timed waits still
 * end.
 */
public final class LabClock implements TimeSource, AutoCloseable {
    private static final Logger LOG = System.getLogger(LabClock.class.getName());
    private static final long LOOK_NANOS = 250_000_000;
    private static final int STALLED_SECONDS = 10;
    private static final long NEVER = Long.MAX_VALUE;

    private final long stepNanos;
    private final Runnable lab;
    private final Pacing pacing;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition membersWait = lock.newCondition();
    private final NavigableSet<Waiter> waiting = new TreeSet<>(
            Comparator.<Waiter>comparingLong(waiter -> waiter.deadline).thenComparingLong(waiter -> waiter.number));
    private final Map<Thread, ClockMember> members = new HashMap<>();
    private final StallDetector watch;
    private volatile long nowNanos;
    private volatile @Nullable String ended;
    private int running;
    private long awakenings;
    private long pauses;
    private long overSystemNanos;
    private volatile boolean over;
    private volatile boolean closed;

    /**
     * Creates a clock at time 0 that does not run yet.
     *
     * @param stepNanos lab time of one step, ns. The clock shows the new time before the lab takes the step, because a
     *     driver may handle what a robot sends while the step is not yet over.
     * @param lab advances the lab by one step; called on the clock's own thread
     * @param pacing when the clock may take a step
     */
    public LabClock(long stepNanos, Runnable lab, Pacing pacing) {
        this(stepNanos, lab, pacing, STALLED_SECONDS);
    }

    /**
     * Creates a clock that ends after another time without an advance.
     *
     * @param stalledSeconds real time, s; used by a stepped clock only
     */
    LabClock(long stepNanos, Runnable lab, Pacing pacing, int stalledSeconds) {
        watch = new StallDetector(stalledSeconds);
        this.stepNanos = stepNanos;
        this.lab = lab;
        this.pacing = pacing;
    }

    /** Starts to advance, on a daemon thread of its own. */
    public void start() {
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
        return over ? nowNanos + System.nanoTime() - overSystemNanos : nowNanos;
    }

    @Override
    public Signal signal() {
        return new LabSignal();
    }

    @Override
    public Thread thread(String name, Runnable body) {
        Thread thread = new MemberThread(name, body);
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public Membership join() {
        Thread thread = Thread.currentThread();
        if (!enter(thread)) {
            return () -> {};
        }
        return () -> leave(thread);
    }

    /** A thread that is a member from the call of {@link #start()}, unless that fails, to its end. */
    private final class MemberThread extends Thread {
        private final Runnable body;

        MemberThread(String name, Runnable body) {
            super(name);
            this.body = body;
        }

        @Override
        public synchronized void start() {
            boolean entered = enter(this);
            boolean started = false;
            try {
                super.start();
                started = true;
            } finally {
                if (entered && !started) {
                    leave(this);
                }
            }
        }

        @Override
        public void run() {
            try {
                body.run();
            } catch (ClockEnded e) {
                LOG.log(Level.DEBUG, "{0} ends with the clock", getName());
            } finally {
                leave(this);
            }
        }
    }

    /** Makes the thread a member; returns false if it is one already. */
    private boolean enter(Thread thread) {
        lock.lock();
        try {
            if (members.containsKey(thread)) {
                return false;
            }
            members.put(thread, new ClockMember());
            running++;
            awakenings++;
            return true;
        } finally {
            lock.unlock();
        }
    }

    private void leave(Thread thread) {
        lock.lock();
        try {
            if (members.remove(thread) != null) {
                running--;
                membersWait.signalAll();
            }
        } finally {
            lock.unlock();
        }
    }

    private void run() {
        try {
            while (!closed && ended == null) {
                long seen = awaitMembers();
                if (!closed && pacing.mayStep(nowNanos, this::membersWait)) {
                    advance(seen);
                } else if (pacing.awaitsMembers()) {
                    endIfStuck();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "the simulated lab has ended", e);
            end("the simulated lab has ended by an error in it (" + e + "), see MAJIC's log; start it again");
        } finally {
            endTurns();
        }
    }

    /**
     * From now on members wake at once and measure their timeouts themselves, since no thread gives them their turn.
     */
    private void endTurns() {
        lock.lock();
        try {
            overSystemNanos = System.nanoTime();
            over = true;
            List.copyOf(waiting).forEach(this::wake);
        } finally {
            lock.unlock();
        }
    }

    private void endIfStuck() {
        lock.lock();
        try {
            boolean waits = nextDeadline() != NEVER;
            if (waits && watch.isOver(members.keySet())) {
                String report = watch.report(members, pacing.toString());
                LOG.log(Level.ERROR, report);
                end(report);
            } else if (!waits) {
                watch.stepped();
            }
        } finally {
            lock.unlock();
        }
    }

    private void end(String why) {
        lock.lock();
        try {
            ended = why;
            List.copyOf(waiting).forEach(this::wake);
        } finally {
            lock.unlock();
        }
    }

    private void refuseEnded() {
        String why = ended;
        if (why != null) {
            throw new ClockEnded(why);
        }
    }

    /** Reports why a wait failed. */
    private static final class ClockEnded extends BotException {
        private static final long serialVersionUID = 1;

        ClockEnded(String message) {
            super(message);
        }
    }

    /**
     * Waits until all members wait, and at least one of them for a later time; returns the number of wake-ups before
     * that.
     */
    private long awaitMembers() throws InterruptedException {
        lock.lockInterruptibly();
        try {
            while (pacing.awaitsMembers() && (running > 0 || nextDeadline() == NEVER) && !closed && ended == null) {
                if (!membersWait.await(LOOK_NANOS, TimeUnit.NANOSECONDS)) {
                    wakeAllDue();
                }
                endIfStuck();
            }
            return awakenings;
        } finally {
            lock.unlock();
        }
    }

    /** Takes a step and wakes the members whose time has come; a stepped clock does one of both. */
    private void advance(long seen) {
        if (!pacing.awaitsMembers()) {
            step();
            wakeAllDue();
        } else if (!hasWoken(seen) && !wakeNextDue()) {
            step();
        }
    }

    private void step() {
        nowNanos += stepNanos;
        lab.run();
        watch.stepped();
    }

    private void wakeAllDue() {
        boolean more = wakeNextDue();
        while (more) {
            more = wakeNextDue();
        }
    }

    /** Returns whether there was one. */
    private boolean wakeNextDue() {
        lock.lock();
        try {
            if (nextDeadline() > nowNanos) {
                return false;
            }
            wake(waiting.first());
            return true;
        } finally {
            lock.unlock();
        }
    }

    /** Whether all members wait, except those that have run for so long that they do more than follow the lab. */
    private boolean membersWait() {
        lock.lock();
        try {
            return running == 0 || members.values().stream().noneMatch(member -> member.hasRunLessThan(LOOK_NANOS));
        } finally {
            lock.unlock();
        }
    }

    private long nextDeadline() {
        return waiting.isEmpty() ? NEVER : waiting.first().deadline;
    }

    private boolean hasWoken(long seen) {
        lock.lock();
        try {
            return running > 0 || awakenings != seen;
        } finally {
            lock.unlock();
        }
    }

    /** Lets a member of a stepped clock wake when its turn comes; wakes any other thread at once. */
    private void wakeInTurn(Waiter waiter) {
        if (waiter.member == null || over || !pacing.awaitsMembers()) {
            wake(waiter);
        } else if (waiter.deadline > nowNanos) {
            waiting.remove(waiter);
            waiter.deadline = nowNanos;
            waiting.add(waiter);
            membersWait.signalAll();
        }
    }

    private void wake(Waiter waiter) {
        if (waiter.woken) {
            return;
        }
        waiter.woken = true;
        waiting.remove(waiter);
        if (waiter.member != null) {
            waiter.member.runs();
            running++;
            awakenings++;
        }
        waiter.wakeUp.signal();
    }

    /** One wait of one thread. Guarded by the clock's lock. */
    private final class Waiter {
        private long deadline;
        private final long number = ++pauses;
        private final @Nullable ClockMember member = members.get(Thread.currentThread());
        private final Condition wakeUp = lock.newCondition();
        private boolean woken;

        Waiter(long deadline) {
            this.deadline = deadline;
        }
    }

    /** A signal whose timeouts are in the lab's time. */
    private final class LabSignal extends CountingSignal {
        private final Set<Waiter> waiters = new HashSet<>();

        LabSignal() {
            super(LabClock.this.lock);
        }

        @Override
        protected long nanos() {
            return LabClock.this.nanos();
        }

        @Override
        protected void pause(long deadlineNanos) throws InterruptedException {
            refuseEnded();
            Waiter waiter = new Waiter(deadlineNanos);
            try {
                fallAsleep(waiter);
                while (!waiter.woken && !isOverdue(waiter)) {
                    awaitWakeUp(waiter);
                }
            } finally {
                wake(waiter);
                waiters.remove(waiter);
            }
        }

        private boolean isOverdue(Waiter waiter) {
            return over && waiter.deadline <= nanos();
        }

        private void awaitWakeUp(Waiter waiter) throws InterruptedException {
            if (over && waiter.deadline != NEVER) {
                waiter.wakeUp.awaitNanos(waiter.deadline - nanos());
            } else {
                waiter.wakeUp.await();
            }
        }

        @Override
        protected void wakeAll() {
            waiters.forEach(LabClock.this::wakeInTurn);
            waiters.clear();
        }

        private void fallAsleep(Waiter waiter) {
            waiters.add(waiter);
            waiting.add(waiter);
            if (waiter.member != null) {
                waiter.member.waits();
                running--;
            }
            membersWait.signalAll();
        }
    }
}
