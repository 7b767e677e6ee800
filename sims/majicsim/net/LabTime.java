package majicsim.net;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The time of a lab, and what its steps have to do: tasks, each of which is due at a time of its own. The due times are
 * one array, so that a step does not load the memory of tasks that are not due. Guarded by the lab's lock, but for
 * {@link #nowNanos()} and {@link #makeAllDue()}.
 */
public final class LabTime {
    /** Set without a fence, because that would cost more than the rest of a step. */
    private final AtomicLong nowNanos = new AtomicLong();

    private final List<Runnable> tasks = new ArrayList<>();
    private long[] dueNanos = {};
    private long beforeNanos;
    private long lineNanos;
    private volatile boolean allDue;

    /**
     * The time now.
     *
     * @return ns since the lab was opened
     */
    public long nowNanos() {
        return nowNanos.get();
    }

    /** The time at the end of the step before this one, ns. */
    long beforeNanos() {
        return beforeNanos;
    }

    /**
     * The time of bytes that enter a line now, ns: what a firmware sends in its step has the time of the step before.
     */
    long lineNanos() {
        return lineNanos;
    }

    /**
     * Adds a task, which is due at once. Tasks that are due in the same step run in the order in which they were added.
     *
     * @param task states at each run when it is due again
     * @return when it is due
     */
    public DueTime add(Runnable task) {
        int number = tasks.size();
        tasks.add(task);
        dueNanos = Arrays.copyOf(dueNanos, number + 1);
        return new DueTime(this, number);
    }

    /**
     * Takes a step: time advances, then all tasks that are due run.
     *
     * @param nanos length of the step, above 0
     */
    public void step(long nanos) {
        beforeNanos = nowNanos();
        long now = beforeNanos + nanos;
        reach(now);
        if (allDue) {
            allDue = false;
            Arrays.fill(dueNanos, now);
        }
        for (int number = 0; number < dueNanos.length; number++) {
            if (dueNanos[number] <= now) {
                dueNanos[number] = Long.MAX_VALUE;
                tasks.get(number).run();
            }
        }
        reach(now);
    }

    /** Begins the step of a firmware. */
    void beginFirmware() {
        lineNanos = beforeNanos;
    }

    /** Reports that the lines have reached this time, ns. */
    void reach(long labNanos) {
        if (nowNanos() != labNanos) {
            nowNanos.lazySet(labNanos);
        }
        lineNanos = labNanos;
    }

    /** Lets the next step run all tasks; may be called from any thread without the lock. */
    void makeAllDue() {
        allDue = true;
    }

    void lowerDue(int task, long nanos) {
        dueNanos[task] = Math.min(dueNanos[task], nanos);
    }
}
