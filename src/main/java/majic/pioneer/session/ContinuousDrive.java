package majic.pioneer.session;

import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.MotionFailed;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A drive at a given velocity until the next command, which ends by itself at the same faults as a motion. The reason
 * is thrown by the next call of {@link #drive}, or given as a notice by {@link #stop}. For one session; thread-safe.
 */
public final class ContinuousDrive {
    private final WheelMotors motors;
    private final Supplier<PioneerState> state;
    private final Supplier<Equipment> equipment;
    private final TimeSource time;
    private final Consumer<String> notice;
    private @Nullable MotionFaults faults;
    private MotionFaults.@Nullable Direction direction;
    private @Nullable String endReason;
    private long beganNanos;

    ContinuousDrive(
            WheelMotors motors,
            Supplier<PioneerState> state,
            Supplier<Equipment> equipment,
            TimeSource time,
            Consumer<String> notice) {
        this.state = state;
        this.equipment = equipment;
        this.motors = motors;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Begins a drive, or changes its motors.
     *
     * @throws MotionFailed if a fault has ended the drive; the next call begins a new one
     */
    public void drive(double mmPerSec, double degPerSec) {
        failIfEnded();
        motors.switchOnWithoutWaiting();
        go(mmPerSec, degPerSec);
    }

    /** Shares its lock with {@link #check}, so that no velocity is sent after the end of the drive. */
    private synchronized void go(double mmPerSec, double degPerSec) {
        failIfEnded();
        begin(MotionFaults.Direction.of(mmPerSec));
        motors.drive(mmPerSec, degPerSec);
    }

    private synchronized void failIfEnded() {
        String reason = endReason;
        if (reason != null) {
            end();
            throw new MotionFailed(reason);
        }
    }

    private void begin(MotionFaults.Direction now) {
        if (now != direction) {
            direction = now;
            faults = new MotionFaults(equipment.get(), now, state.get());
            beganNanos = time.nanos();
        }
    }

    /** Checks a reported state, and stops the robot at a fault. */
    synchronized void check(PioneerState now) {
        MotionFaults watched = faults;
        String reason = watched == null ? null : watched.check(now, time.secondsSince(beganNanos));
        if (reason != null) {
            end();
            endReason = reason;
            motors.stop();
        }
    }

    /** Ends the drive, if there is one, and stops the robot in any case. */
    public void stop() {
        String reason = endAndStop();
        if (reason != null) {
            notice.accept("the drive ended: " + reason);
        }
    }

    private synchronized @Nullable String endAndStop() {
        String reason = endReason;
        end();
        motors.stop();
        return reason;
    }

    private void end() {
        faults = null;
        direction = null;
        endReason = null;
    }
}
