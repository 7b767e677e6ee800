package majic.velocity;

import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.driver.RenewalWatch;
import org.jspecify.annotations.Nullable;

/**
 * A drive at a given velocity until the next command: follows it with limited acceleration, and ends by itself at a
 * contact, without progress, or when the odometry fails. The reason is thrown by the next {@link #drive}, or returned
 * by {@link #stop}. Thread-safe; never waits.
 */
final class VelocityDrive {
    /** A base may slow down faster than it gains speed, by this factor. */
    private static final double BRAKING = 2;

    private final MovingBase base;
    private final ObstructionSource obstructions;
    private final BaseDynamics limits;
    private @Nullable MotionWatcher watcher;
    private final RenewalWatch renewals;
    private @Nullable String endReason;
    private double wantedMmPerSec;
    private double wantedDegPerSec;
    private double mmPerSec;
    private double degPerSec;
    private long steppedNanos;

    VelocityDrive(MovingBase base, ObstructionSource obstructions, BaseDynamics limits) {
        this.base = base;
        this.obstructions = obstructions;
        this.limits = limits;
        this.renewals = new RenewalWatch(base.time());
    }

    /**
     * Begins a drive, or changes its velocity.
     *
     * @throws MotionFailed if the drive has ended by itself, which the next call does not report again; or before the
     *     first odometry
     * @throws LinkLost if the connection has ended
     */
    synchronized void drive(double newMmPerSec, double newDegPerSec) {
        failIfEnded();
        long now = base.time().nanos();
        if (watcher == null) {
            renewals.renewed();
        }
        if (watcher == null || Math.signum(newMmPerSec) != Math.signum(wantedMmPerSec)) {
            steppedNanos = watcher == null ? now - (long) (VelocitySender.PERIOD_S * 1e9) : steppedNanos;
            watcher = new MotionWatcher(base, obstructions, newMmPerSec);
        }
        wantedMmPerSec = newMmPerSec;
        wantedDegPerSec = newDegPerSec;
        step();
        failIfEnded();
    }

    private void failIfEnded() {
        String reason = endReason;
        if (reason != null) {
            end();
            throw new MotionFailed(reason);
        }
    }

    /** Sends the next velocity of the drive that is under way, or ends it. */
    synchronized void step() {
        MotionWatcher watching = watcher;
        if (watching == null) {
            return;
        }
        long now = base.time().nanos();
        String late = renewals.late();
        String reason = late == null ? watching.check(base.now()) : late;
        if (reason == null && watching.isBlocked(base.now(), isFollowed())) {
            reason = "blocked: no progress for 2 s";
        }
        if (reason != null) {
            end();
            endReason = reason;
            base.sender().stop();
            return;
        }
        double seconds = Math.min(2 * VelocitySender.PERIOD_S, (now - steppedNanos) / 1e9);
        steppedNanos = now;
        renewals.renewed();
        mmPerSec = stepped(mmPerSec, wantedMmPerSec, limits.accelerationMmPerSec2() * seconds);
        degPerSec = stepped(degPerSec, wantedDegPerSec, limits.accelerationDegPerSec2() * seconds);
        base.sender().send(mmPerSec, degPerSec);
    }

    private boolean isFollowed() {
        return Math.abs(mmPerSec) >= limits.slowestMmPerSec() || Math.abs(degPerSec) >= limits.slowestDegPerSec();
    }

    private static double stepped(double from, double to, double most) {
        double largest = Math.abs(to) < Math.abs(from) || from * to < 0 ? BRAKING * most : most;
        return from + Math.max(-largest, Math.min(largest, to - from));
    }

    /**
     * Ends the drive, if there is one, and stops the base in any case.
     *
     * @return why the drive had ended by itself; null if it had not
     * @throws LinkLost if the connection has ended
     */
    synchronized @Nullable String stop() {
        String reason = endReason;
        end();
        base.sender().stop();
        return reason;
    }

    private void end() {
        watcher = null;
        endReason = null;
        wantedMmPerSec = 0;
        wantedDegPerSec = 0;
        mmPerSec = 0;
        degPerSec = 0;
    }
}
