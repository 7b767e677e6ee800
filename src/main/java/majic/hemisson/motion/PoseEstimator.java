package majic.hemisson.motion;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import majic.bot.BotState;
import majic.bot.Pose;
import majic.driver.DeadReckoning;
import majic.hemisson.line.MotorValues;
import majic.time.TimeSource;

/** Estimates the pose from the motor values that were sent, and publishes it. Thread-safe. */
public final class PoseEstimator {
    private final TimeSource time;
    private final Consumer<BotState> states;
    private final BooleanSupplier mayMoveUnreported;
    private final DeadReckoning reckoning = new DeadReckoning();
    private volatile Wheels wheels;

    /** Motor values, the time from which they hold, and their speeds. */
    private record Wheels(MotorValues values, long sinceNanos, SpeedTable table) implements DeadReckoning.Segment {
        @Override
        public Pose at(Pose start, long nanos) {
            double seconds = Math.max(0, nanos - sinceNanos) / 1e9;
            return start.after(table.speedMmPerSec(values) * seconds, table.turnDegPerSec(values) * seconds);
        }
    }

    /**
     * Stationary at its start.
     *
     * @param states takes each new estimate; called by any thread, must not block
     * @param mayMoveUnreported whether the robot may move by itself without a way to ask for its speeds
     */
    PoseEstimator(TimeSource time, SpeedTable table, Consumer<BotState> states, BooleanSupplier mayMoveUnreported) {
        this.time = time;
        this.states = states;
        this.mayMoveUnreported = mayMoveUnreported;
        this.wheels = new Wheels(MotorValues.STILL, time.nanos(), table);
    }

    /** The present motor values. */
    public MotorValues wheels() {
        return wheels.values();
    }

    /** When the present motor values began, on the robot's clock, ns. */
    long sinceNanos() {
        return wheels.sinceNanos();
    }

    /** Starts again at the start pose, for a new connection. */
    synchronized void begin() {
        reckoning.reset();
        wheels = new Wheels(MotorValues.STILL, time.nanos(), wheels.table());
    }

    /** Uses another calibration from now on. */
    public synchronized void use(SpeedTable table) {
        begin(new Wheels(wheels.values(), time.nanos(), table));
    }

    /** Records the motor values from a time on, and publishes the state. */
    void follow(MotorValues values, long nanos) {
        synchronized (this) {
            begin(new Wheels(values, Math.max(nanos, wheels.sinceNanos()), wheels.table()));
        }
        publish();
    }

    private void begin(Wheels next) {
        reckoning.begin(next, next.sinceNanos());
        wheels = next;
    }

    /** Publishes the estimate for now. */
    void publish() {
        states.accept(state());
    }

    private synchronized BotState state() {
        long now = time.nanos();
        MotorValues values = wheels.values();
        SpeedTable table = wheels.table();
        boolean moving = !values.isStill() || mayMoveUnreported.getAsBoolean();
        return new BotState(reckoning.at(now), table.speedMmPerSec(values), table.turnDegPerSec(values), moving, now);
    }
}
