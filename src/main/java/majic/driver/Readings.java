package majic.driver;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.time.Signal;

/**
 * The readings of one robot: its newest state, with the pose in the frame in which the robot was placed, and what waits
 * for new ones. Thread-safe; calls watchers with no lock held.
 */
final class Readings {
    private final Signal changes;
    private final PoseOffset offset = new PoseOffset();
    private final List<Runnable> watchers = new CopyOnWriteArrayList<>();
    private final AtomicLong count = new AtomicLong();
    private volatile BotState state = BotState.UNKNOWN;

    /**
     * No readings yet.
     *
     * @param changes raised after each reading
     */
    Readings(Signal changes) {
        this.changes = changes;
    }

    BotState state() {
        return state;
    }

    /** Takes the state that the robot reports. */
    void report(BotState reported) {
        synchronized (offset) {
            state = offset.reported(reported);
        }
        news();
    }

    /** Sets the pose of the robot's present place. */
    void place(Pose pose) {
        synchronized (offset) {
            state = offset.place(pose);
        }
        news();
    }

    /** Returns the pose that was set last; empty if there is none. */
    Optional<Pose> placedAt() {
        return offset.start();
    }

    /** The next report begins a new session: the robot may count its pose from zero again. */
    void reconnecting() {
        offset.reconnecting();
    }

    /** Reports that something can be read anew: wakes the threads that wait, and calls the watchers. */
    void news() {
        lookAgain();
        watchers.forEach(Runnable::run);
    }

    /** Counts a reading that this robot's motions depend on, and wakes the threads that wait. */
    void lookAgain() {
        count.incrementAndGet();
        changes.raise();
    }

    /** Returns the number of readings so far. */
    long count() {
        return count.get();
    }

    void addWatcher(Runnable watcher) {
        watchers.add(watcher);
    }

    void removeWatcher(Runnable watcher) {
        watchers.remove(watcher);
    }
}
