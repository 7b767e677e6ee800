package majic.velocity;

import org.jspecify.annotations.Nullable;

/**
 * Finds what ends a motion from the robot's side: contacts, odometry that is silent or jumps, no progress. For one
 * motion or one drive; used by one thread at a time.
 */
final class MotionWatcher {
    /** A base that has not moved for so long in spite of a velocity is taken to be blocked, seconds. */
    private static final double BLOCKED_S = 2;

    /** A contact that was reported longer before the motion than this was over when it began, seconds. */
    private static final double OLD_S = 0.3;

    private final MovingBase base;
    private final ObstructionSource obstructions;
    private final boolean ahead;
    private final boolean back;
    private final long startNanos;
    private final @Nullable Obstruction before;
    private TrackedState progressed;
    private long progressNanos;

    /**
     * Begins to watch.
     *
     * @param direction of the motion: positive ahead, negative back, zero on the spot
     */
    MotionWatcher(MovingBase base, ObstructionSource obstructions, double direction) {
        this.base = base;
        this.obstructions = obstructions;
        this.ahead = direction > 0;
        this.back = direction < 0;
        this.startNanos = base.time().nanos();
        this.before = obstructions.newest();
        this.progressed = base.now();
        this.progressNanos = startNanos;
    }

    /**
     * Checks the newest state.
     *
     * @param now the state
     * @return the reason to end the motion, as half a sentence; null if there is none
     */
    @Nullable
    String check(TrackedState now) {
        String found = obstructed();
        if (found != null) {
            return found;
        }
        if (now.jumps() != progressed.jumps()) {
            return "its odometry jumped";
        }
        return base.silence();
    }

    /**
     * Checks the progress of a base.
     *
     * @param commanded whether a velocity is in force that it should follow
     * @return whether it has not moved for 2 s in spite of such a velocity, and the odometry shows it
     */
    boolean isBlocked(TrackedState now, boolean commanded) {
        long nowNanos = base.time().nanos();
        if (!commanded
                || now.pose().distanceMm(progressed.pose()) >= base.accuracy().progressMm()
                || Math.abs(now.turnedDeg() - progressed.turnedDeg())
                        >= base.accuracy().progressDeg()) {
            progressed = now;
            progressNanos = nowNanos;
        }
        return (nowNanos - progressNanos) / 1e9 >= BLOCKED_S + base.delay().seconds();
    }

    private @Nullable String obstructed() {
        Obstruction newest = obstructions.newest();
        if (newest == null || isOver(newest) || !prevents(newest)) {
            return null;
        }
        return newest.reflex() ? "its own reflex stopped it: " + newest.what() : newest.what();
    }

    /** On the spot a contact counts only if it is new: the base may have to turn away from it. */
    private boolean prevents(Obstruction found) {
        return switch (found.side()) {
            case ALL -> true;
            case FRONT -> ahead || (!back && isNew(found));
            case REAR -> back || (!ahead && isNew(found));
        };
    }

    private boolean isNew(Obstruction found) {
        return before == null || !before.what().equals(found.what()) || isOver(before);
    }

    private boolean isOver(Obstruction found) {
        return (startNanos - found.atNanos()) / 1e9 > OLD_S;
    }
}
