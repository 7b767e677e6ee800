package majic.pioneer.session;

import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MotionFailed;
import majic.driver.Motion;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The power of the motors, and the speed and turn rate that were last sent to the robot. A drive has a velocity until
 * the next command, and ends by itself at the same faults as a motion. When the robot's reports stop while it moves,
 * speed and turn rate are set to zero and held there until it reports again that it is stationary: it would resume any
 * other velocity as soon as the line works again. For one session; thread-safe.
 */
public final class WheelMotors {
    /** Time enough for ENABLE and the SIP that shows its effect, seconds. */
    private static final double ON_S = 1;

    /** A velocity that is not renewed for so long is set to zero, seconds; drivers renew it several times as often. */
    private static final double RENEWAL_S = 1;

    private final RobotLine line;
    private final Supplier<PioneerState> state;
    private final Supplier<Equipment> equipment;
    private final TimeSource time;
    private final Consumer<String> notice;
    private volatile long requestedNanos;
    private volatile boolean announced = true;
    private long sentNanos;
    private boolean turning;
    private boolean rolling;
    private boolean held;
    private int holds;

    /** Those of the drive; null without one. */
    private @Nullable MotionFaults faults;

    private MotionFaults.@Nullable Direction direction;
    private @Nullable String endReason;
    private long beganNanos;

    WheelMotors(
            RobotLine line,
            Supplier<PioneerState> state,
            Supplier<Equipment> equipment,
            TimeSource time,
            Consumer<String> notice) {
        this.line = line;
        this.state = state;
        this.equipment = equipment;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Switches the motors on before a motion and waits until the robot reports them on: it ignores motion before that.
     *
     * @throws MotionFailed if they are not on within 1 s
     */
    public void switchOn(Motion motion) {
        if (state.get().motorsOn()) {
            return;
        }
        motion.send(this::requestPower);
        if (!motion.await(() -> state.get().motorsOn(), ON_S) && !motion.guardReached()) {
            throw new MotionFailed("the motors do not switch on; is the STOP button on the robot pressed?");
        }
    }

    /** Switches the motors on without waiting, for a drive; sends the command at most once a second. */
    private void switchOnWithoutWaiting() {
        boolean requested = requestedNanos != 0 && time.secondsSince(requestedNanos) < ON_S;
        if (!state.get().motorsOn() && !requested) {
            requestPower();
        }
    }

    private void requestPower() {
        if (state.get().stopButton()) {
            throw new BotException("the STOP button on the robot is pressed");
        }
        requestedNanos = time.nanos();
        announceOn();
        line.send(ArcosCommand.ENABLE.packet(1));
    }

    /** Announces the motors when the robot next reports them on. */
    public void announceOn() {
        announced = false;
    }

    /**
     * Takes in a report: announces motors that were switched on, ends a hold of a robot that is stationary, and stops
     * the robot at a fault during a drive.
     */
    void reported(PioneerState now) {
        if (!announced && now.motorsOn()) {
            announced = true;
            notice.accept("motors on");
        }
        if (!now.isMoving()) {
            release();
        }
        endAtFault(now);
    }

    /**
     * Begins a drive, or changes its velocity.
     *
     * @throws MotionFailed if a fault has ended the drive; the next call begins a new one
     */
    public void drive(double mmPerSec, double degPerSec) {
        failIfEnded();
        switchOnWithoutWaiting();
        driveOn(mmPerSec, degPerSec);
    }

    /** Shares its lock with {@link #endAtFault}, so that no velocity is sent after the end of the drive. */
    private synchronized void driveOn(double mmPerSec, double degPerSec) {
        failIfEnded();
        beginDrive(MotionFaults.Direction.of(mmPerSec));
        setVelocity(mmPerSec, degPerSec);
    }

    private synchronized void failIfEnded() {
        String reason = endReason;
        if (reason != null) {
            forgetDrive();
            throw new MotionFailed(reason);
        }
    }

    private void beginDrive(MotionFaults.Direction now) {
        if (now != direction) {
            direction = now;
            faults = new MotionFaults(equipment.get(), now, state.get());
            beganNanos = time.nanos();
        }
    }

    private synchronized void endAtFault(PioneerState now) {
        MotionFaults watched = faults;
        String reason = watched == null ? null : watched.check(now, time.secondsSince(beganNanos));
        if (reason != null) {
            forgetDrive();
            endReason = reason;
            sendStop();
        }
    }

    private void forgetDrive() {
        faults = null;
        direction = null;
        endReason = null;
    }

    /** Ends the drive, if there is one, and stops the robot in any case. A fault that ended it before is a notice. */
    public void stop() {
        String reason = endAndStop();
        if (reason != null) {
            notice.accept("the drive ended: " + reason);
        }
    }

    private synchronized @Nullable String endAndStop() {
        String reason = endReason;
        forgetDrive();
        sendStop();
        return reason;
    }

    /**
     * Sends a speed and a turn rate.
     *
     * @throws MotionFailed while the setpoint is held at zero; nothing was sent
     */
    synchronized void setVelocity(double mmPerSec, double degPerSec) {
        if (held) {
            throw new MotionFailed("stopped, for the robot fell silent while it moved");
        }
        int speed = (int) Math.round(mmPerSec);
        int rate = (int) Math.round(degPerSec);
        rolling = speed != 0;
        turning = rate != 0;
        sentNanos = time.nanos();
        send(ArcosCommand.VEL.packet(speed), ArcosCommand.RVEL.packet(rate));
    }

    /** Sends first what moves the robot: a turn on the spot begins with its turn rate. */
    private void send(Packet speed, Packet rate) {
        if (rolling) {
            line.send(speed, rate);
        } else {
            line.send(rate, speed);
        }
    }

    /** Stops the robot; zero velocities follow STOP, which not every server obeys. */
    synchronized void sendStop() {
        rolling = false;
        turning = false;
        line.send(ArcosCommand.STOP.packet(), ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /**
     * Sends zero velocities if others are in force, as for a robot that is stationary at its target but still has a low
     * speed to follow.
     */
    synchronized void zero() {
        if (isMoving()) {
            sendStop();
        }
    }

    /** Stops the robot if its velocity is not renewed, as when a guard condition of a program does not return. */
    synchronized void stopIfNotRenewed() {
        if (isMoving() && time.secondsSince(sentNanos) > RENEWAL_S) {
            sendStop();
        }
    }

    /** Sends zero velocities and refuses all others until the robot reports that it is stationary. */
    synchronized void hold() {
        held = true;
        holds++;
        rolling = false;
        turning = false;
        line.sendIfPossible(ArcosCommand.VEL.packet(0), ArcosCommand.RVEL.packet(0));
    }

    /** Accepts velocities again: the robot has reported that it is stationary. */
    private synchronized void release() {
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
    public synchronized boolean isMoving() {
        return rolling || turning;
    }
}
