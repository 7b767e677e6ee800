package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import majic.bot.BotException;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;

/**
 * The timer thread of one robot, for scheduled tasks: watchdog pulses, the end of a drive that was not renewed. Each
 * robot has its own, so that a stuck connection does not delay the tasks of other robots.
 */
final class RobotTimer {
    private static final Logger LOG = System.getLogger(RobotTimer.class.getName());

    private final TimeSource time;
    private final Signal changed;
    private final Map<String, Task> tasks = new HashMap<>();
    private boolean closed;

    private record Task(long dueNanos, long periodNanos, Runnable task) {
        Task again(long nowNanos) {
            return new Task(Math.max(dueNanos + periodNanos, nowNanos), periodNanos, task);
        }
    }

    RobotTimer(TimeSource time) {
        this.time = time;
        this.changed = time.signal();
    }

    void start(String name) {
        time.thread(name + " timer", () -> WaitPolicy.without(this::run)).start();
    }

    /** Replaces any task of the same name. */
    void every(String name, double seconds, Runnable task) {
        put(name, new Task(time.nanos() + nanos(seconds), nanos(seconds), task));
    }

    /** Replaces any task of the same name. */
    void once(String name, double seconds, Runnable task) {
        put(name, new Task(time.nanos() + nanos(seconds), 0, task));
    }

    void close() {
        synchronized (tasks) {
            closed = true;
            tasks.clear();
        }
        changed.raise();
    }

    private void put(String name, Task next) {
        boolean sooner;
        synchronized (tasks) {
            sooner = next.dueNanos < nextDue();
            tasks.put(name, next);
        }
        if (sooner) {
            changed.raise();
        }
    }

    private void run() {
        try {
            while (!isClosed()) {
                long due = dueNanos();
                changed.await(() -> isClosed() || dueNanos() < due, waitSeconds(due));
                runDue();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Whatever becomes of one task, the pulses go on and a drive that is not renewed ends. */
    private void runDue() {
        for (Runnable task : takeDue(time.nanos())) {
            try {
                task.run();
            } catch (BotException e) {
                LOG.log(Level.DEBUG, "a scheduled task of a robot failed", e);
            } catch (RuntimeException | Error e) {
                LOG.log(Level.WARNING, "a scheduled task of a robot failed", e);
            }
        }
    }

    private List<Runnable> takeDue(long now) {
        synchronized (tasks) {
            if (nextDue() > now) {
                return List.of();
            }
            List<Runnable> due = new ArrayList<>();
            Map<String, Task> again = new HashMap<>();
            for (Iterator<Map.Entry<String, Task>> all = tasks.entrySet().iterator(); all.hasNext(); ) {
                Map.Entry<String, Task> entry = all.next();
                Task next = entry.getValue();
                if (next.dueNanos <= now) {
                    due.add(next.task);
                    all.remove();
                    if (next.periodNanos > 0) {
                        again.put(entry.getKey(), next.again(now));
                    }
                }
            }
            tasks.putAll(again);
            return due;
        }
    }

    private boolean isClosed() {
        synchronized (tasks) {
            return closed;
        }
    }

    private long dueNanos() {
        synchronized (tasks) {
            return nextDue();
        }
    }

    private long nextDue() {
        long next = Long.MAX_VALUE;
        for (Task task : tasks.values()) {
            next = Math.min(next, task.dueNanos);
        }
        return next;
    }

    private double waitSeconds(long due) {
        return due == Long.MAX_VALUE ? Signal.FOR_EVER : (due - time.nanos()) / 1e9;
    }

    private static long nanos(double seconds) {
        return (long) (seconds * 1e9);
    }
}
