package majic.hemisson.motion;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.hemisson.line.MotorValues;
import majic.time.TimeSource;

/** Estimates the pose from the motor values and publishes it. Thread-safe. */
public final class PoseEstimator {
    private final TimeSource time;
    private final Consumer<BotState> states;
    private final BooleanSupplier mayMoveUnreported;
    private volatile PoseEstimate track;

    /**
     * Stationary at its start.
     *
     * @param states takes each new estimate; called by any thread, must not wait
     * @param mayMoveUnreported whether the robot may move by itself without a way to ask for its speeds
     */
    PoseEstimator(TimeSource time, SpeedTable table, Consumer<BotState> states, BooleanSupplier mayMoveUnreported) {
        this.time = time;
        this.states = states;
        this.mayMoveUnreported = mayMoveUnreported;
        this.track = PoseEstimate.standing(Pose.START, time.nanos(), table);
    }

    public PoseEstimate track() {
        return track;
    }

    /** Starts again at the start pose, for a new connection. */
    void begin() {
        track = PoseEstimate.standing(Pose.START, time.nanos(), track.table());
    }

    /** Uses another calibration from now on. */
    public void use(SpeedTable table) {
        long now = time.nanos();
        track = new PoseEstimate(track.at(now), now, track.wheels(), table);
    }

    /** Records the motor values from a moment on, and publishes the state. */
    void follow(MotorValues wheels, long nanos) {
        track = track.then(wheels, nanos);
        publish();
    }

    /** Publishes where the robot should be now. */
    void publish() {
        boolean moving = !track.wheels().isStill() || mayMoveUnreported.getAsBoolean();
        states.accept(track.state(time.nanos(), moving));
    }
}
