package majic.pioneer.session;

import majic.bot.MotionFailed;
import majic.pioneer.arcos.ArcosCommand;
import majic.time.TimeSource;

/**
 * The speed and turn rate the robot was last told. Once the robot has gone silent while it moved, they are zero and stay
 * so until it speaks again and stands: it would take up anything else when the line comes back. Thread-safe.
 */
public final class VelocitySetpoint {
    /** Whoever drives says so several times as often, seconds. */
    private static final double RENEWAL_S = 1;

    private final ArcosLine line;
    private final TimeSource time;
    private long toldNanos;
    private boolean turning;
    private boolean rolling;
    private boolean held;
    private int holds;

    VelocitySetpoint(ArcosLine line, TimeSource time) {
        this.line = line;
        this.time = time;
    }

    /**
     * Tells the robot to go.
     *
     * @throws MotionFailed if it fell silent while it moved and has not been seen to stand since; nothing was sent
     */
    synchronized void drive(double mmPerSec, double degPerSec) {
        if (held) {
            throw new MotionFailed("stopped, for the robot fell silent while it moved");
        }
        int speed = (int) Math.round(mmPerSec);
        int rate = (int) Math.round(degPerSec);
        rolling = speed != 0;
        turning = rate != 0;
        toldNanos = time.nanos();
        line.send(ArcosCommand.VEL.packet(speed), ArcosCommand.RVEL.packet(rate));
    }

    /** Tells the robot to stand; not by STOP alone, which not every server obeys. */
    synchronized void stop() {
        rolling = false;
        turning = false;
        line.send(ArcosCommand.STOP.packet(), ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /** Takes back what the robot was last told, where it stands although it was told to creep on. */
    synchronized void stand() {
        if (areDriven()) {
            stop();
        }
    }

    /** Lets the robot stand if whoever drives it says nothing more, as when a guard of a program does not return. */
    synchronized void standIfForgotten() {
        if (areDriven() && time.secondsSince(toldNanos) > RENEWAL_S) {
            stop();
        }
    }

    /** Tells the robot to stand and refuses to tell it anything else. */
    synchronized void hold() {
        held = true;
        holds++;
        rolling = false;
        turning = false;
        line.sendIfPossible(ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /** The robot speaks again, and stands. */
    synchronized void release() {
        held = false;
    }

    synchronized boolean areHeld() {
        return held;
    }

    /** How often the robot fell silent while it moved. */
    synchronized int holds() {
        return holds;
    }

    /** Whether it was told to move. */
    public synchronized boolean areDriven() {
        return rolling || turning;
    }
}
