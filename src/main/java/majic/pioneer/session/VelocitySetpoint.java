package majic.pioneer.session;

import majic.bot.MotionFailed;
import majic.pioneer.arcos.ArcosCommand;
import majic.time.TimeSource;

/**
 * The speed and turn rate that were last sent to the robot. When its reports stop while it moves, both are set to zero and
 * held there until it reports again that it is stationary: it would resume any other velocity as soon as the line works
 * again. Thread-safe.
 */
public final class VelocitySetpoint {
    /** A velocity that is not renewed for so long is set to zero, seconds; drivers renew it several times as often. */
    private static final double RENEWAL_S = 1;

    private final ArcosLine line;
    private final TimeSource time;
    private long sentNanos;
    private boolean turning;
    private boolean rolling;
    private boolean held;
    private int holds;

    VelocitySetpoint(ArcosLine line, TimeSource time) {
        this.line = line;
        this.time = time;
    }

    /**
     * Sends a speed and a turn rate.
     *
     * @throws MotionFailed while the setpoint is held at zero; nothing was sent
     */
    synchronized void drive(double mmPerSec, double degPerSec) {
        if (held) {
            throw new MotionFailed("stopped, for the robot fell silent while it moved");
        }
        int speed = (int) Math.round(mmPerSec);
        int rate = (int) Math.round(degPerSec);
        rolling = speed != 0;
        turning = rate != 0;
        sentNanos = time.nanos();
        line.send(ArcosCommand.VEL.packet(speed), ArcosCommand.RVEL.packet(rate));
    }

    /** Stops the robot; zero velocities follow STOP, which not every server obeys. */
    synchronized void stop() {
        rolling = false;
        turning = false;
        line.send(ArcosCommand.STOP.packet(), ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /** Sends zero velocities if others are in force, as for a robot that is stationary at its target but still has a low speed to follow. */
    synchronized void zero() {
        if (isNonZero()) {
            stop();
        }
    }

    /** Stops the robot if its velocity is not renewed, as when a guard condition of a program does not return. */
    synchronized void stopIfNotRenewed() {
        if (isNonZero() && time.secondsSince(sentNanos) > RENEWAL_S) {
            stop();
        }
    }

    /** Sends zero velocities and refuses all others until {@link #release}. */
    synchronized void hold() {
        held = true;
        holds++;
        rolling = false;
        turning = false;
        line.sendIfPossible(ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /** Accepts velocities again: the robot has reported that it is stationary. */
    synchronized void release() {
        held = false;
    }

    synchronized boolean isHeld() {
        return held;
    }

    /** How often {@link #hold} was called. */
    synchronized int holds() {
        return holds;
    }

    /** Whether the last velocity sent was not zero. */
    public synchronized boolean isNonZero() {
        return rolling || turning;
    }
}
