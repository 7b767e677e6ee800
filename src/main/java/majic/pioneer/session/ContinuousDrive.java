package majic.pioneer.session;

import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.MotionFailed;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.PioneerState;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A drive that goes on until it is told otherwise, and ends by itself at the same troubles as a motion. Whoever drives
 * hears the reason at the next call, or else as a notice when the drive is over. For one session; thread-safe.
 */
public final class ContinuousDrive {
    private final VelocitySetpoint velocity;
    private final ReportedState state;
    private final Supplier<Bumpers> bumpers;
    private final MotorPower motors;
    private final TimeSource time;
    private final Consumer<String> notice;
    private @Nullable MotionFaults troubles;
    private MotionFaults.@Nullable Direction heading;
    private @Nullable String untold;
    private long beganNanos;

    ContinuousDrive(
            VelocitySetpoint velocity,
            ReportedState state,
            Supplier<Bumpers> bumpers,
            MotorPower motors,
            TimeSource time,
            Consumer<String> notice) {
        this.velocity = velocity;
        this.state = state;
        this.bumpers = bumpers;
        this.motors = motors;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Drives from now on.
     *
     * @throws MotionFailed if a trouble has ended the drive before; the next call begins a new one
     */
    public void drive(double mmPerSec, double degPerSec) {
        failIfEnded();
        motors.switchOnSoon();
        go(mmPerSec, degPerSec);
    }

    /** Under one lock with {@link #look}: nothing is sent after what ends the drive. */
    private synchronized void go(double mmPerSec, double degPerSec) {
        failIfEnded();
        begin(MotionFaults.Direction.of(mmPerSec));
        velocity.drive(mmPerSec, degPerSec);
    }

    private synchronized void failIfEnded() {
        String reason = untold;
        if (reason != null) {
            end();
            throw new MotionFailed(reason);
        }
    }

    private void begin(MotionFaults.Direction now) {
        if (now != heading) {
            heading = now;
            troubles = new MotionFaults(bumpers.get(), now, state.get());
            beganNanos = time.nanos();
        }
    }

    /** Looks at what the robot says, and lets it stand if there is a reason to. */
    synchronized void look(PioneerState now) {
        MotionFaults watched = troubles;
        String reason = watched == null ? null : watched.look(now, time.secondsSince(beganNanos));
        if (reason != null) {
            end();
            untold = reason;
            velocity.stop();
        }
    }

    /** Ends the drive, if there is one, and lets the robot stand in any case. */
    public void stop() {
        String reason = endAndStand();
        if (reason != null) {
            notice.accept("the drive ended: " + reason);
        }
    }

    private synchronized @Nullable String endAndStand() {
        String reason = untold;
        end();
        velocity.stop();
        return reason;
    }

    private void end() {
        troubles = null;
        heading = null;
        untold = null;
    }
}
