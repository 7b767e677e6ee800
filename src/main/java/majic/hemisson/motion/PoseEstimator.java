package majic.hemisson.motion;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.hemisson.line.MotorValues;
import majic.time.TimeSource;

/** Where the robot should be by what its wheels were told, and what it publishes of that. Thread-safe. */
public final class PoseEstimator {
    private final TimeSource time;
    private final Consumer<BotState> states;
    private final BooleanSupplier mayMoveUntold;
    private volatile PoseEstimate track;

    /**
     * Stationary at its start.
     *
     * @param states takes each new estimate; called by any thread, must not wait
     * @param mayMoveUntold whether the robot may move by itself without a way to ask for its speeds
     */
    PoseEstimator(TimeSource time, SpeedTable table, Consumer<BotState> states, BooleanSupplier mayMoveUntold) {
        this.time = time;
        this.states = states;
        this.mayMoveUntold = mayMoveUntold;
        this.track = PoseEstimate.standing(Pose.START, time.nanos(), table);
    }

    public PoseEstimate track() {
        return track;
    }

    /** Begins anew at the start, for a new connection. */
    void begin() {
        track = PoseEstimate.standing(Pose.START, time.nanos(), track.table());
    }

    /** Goes on with another calibration. */
    public void use(SpeedTable table) {
        long now = time.nanos();
        track = new PoseEstimate(track.at(now), now, track.wheels(), table);
    }

    /** Takes note that the wheels were set, by whomever, from a moment on. */
    void follow(MotorValues wheels, long nanos) {
        track = track.then(wheels, nanos);
        publish();
    }

    /** Tells everybody where it should be now. */
    void publish() {
        boolean moving = !track.wheels().isStill() || mayMoveUntold.getAsBoolean();
        states.accept(track.state(time.nanos(), moving));
    }
}
