package majic.driver;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * The readings of one robot: its newest state, with the pose in the frame in which the robot was placed, and what waits
 * for new ones. Thread-safe; calls watchers with no lock held.
 */
final class Readings {
    private final Signal changes;
    private final List<Runnable> watchers = new CopyOnWriteArrayList<>();
    private final AtomicLong count = new AtomicLong();
    private volatile BotState state = BotState.UNKNOWN;

    /** The newest state with the pose by the robot's own odometry; what follows is guarded by the lock of this. */
    private BotState own = BotState.UNKNOWN;

    private Pose origin = Pose.START;
    private @Nullable Pose start;
    private Uncertainty uncertainty = Uncertainty.UNKNOWN;
    private boolean reconnected;

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

    /**
     * Takes the state that the robot reports, whose pose is by its odometry.
     *
     * @param veerDegPerM how much it veers
     */
    void report(BotState reported, double veerDegPerM) {
        synchronized (this) {
            if (reconnected && start != null) {
                origin = origin.plus(own.pose()).originOf(reported.pose());
            } else if (uncertainty.isKnown()) {
                uncertainty = uncertainty.after(
                        state.pose().headingDeg(), reported.pose().seenFrom(own.pose()), veerDegPerM);
            }
            reconnected = false;
            own = reported;
            state = shown();
        }
        news();
    }

    /**
     * Sets the pose of the robot's present place. That changes where users see the robot and never its odometry, so
     * that a motion in progress is not disturbed.
     */
    void place(Pose pose, Uncertainty certain) {
        synchronized (this) {
            start = pose;
            uncertainty = certain;
            origin = pose.originOf(own.pose());
            state = shown();
        }
        news();
    }

    private BotState shown() {
        return start == null
                ? own
                : new BotState(
                        origin.plus(own.pose()),
                        own.speedMmPerSec(),
                        own.turnRateDegPerSec(),
                        own.moving(),
                        own.atNanos());
    }

    /** Returns the origin of the odometry in the frame of the shown poses. */
    synchronized Pose odometryOrigin() {
        return origin;
    }

    /** Returns the pose that was set last; empty if there is none. */
    synchronized Optional<Pose> placedAt() {
        return Optional.ofNullable(start);
    }

    /** Returns how far the true pose may be from the shown one. */
    synchronized Uncertainty uncertainty() {
        return uncertainty;
    }

    /** The next report begins a new session: a placed robot stays where it is, though it may count from zero again. */
    synchronized void reconnecting() {
        reconnected = true;
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
