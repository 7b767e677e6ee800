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
    private volatile long reportedNanos;
    private Way before = Way.NONE;

    /**
     * What the robot has covered, as the pose has it.
     *
     * @param mm ahead, less what it went back
     * @param deg to the left, less what it turned to the right; whole turns count
     */
    record Way(double mm, double deg) {
        static final Way NONE = new Way(0, 0);

        Way plus(Way more) {
            return new Way(mm + more.mm, deg + more.deg);
        }
    }

    /** Motor values, the time from which they hold, and their speeds. */
    private record Wheels(MotorValues values, long sinceNanos, SpeedTable table) implements DeadReckoning.Segment {
        @Override
        public Pose at(Pose start, long nanos) {
            Way way = until(nanos);
            return start.after(way.mm(), way.deg());
        }

        Way until(long nanos) {
            double seconds = Math.max(0, nanos - sinceNanos) / 1e9;
            return new Way(table.speedMmPerSec(values) * seconds, table.turnDegPerSec(values) * seconds);
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

    /** What the robot has covered since it was connected. */
    synchronized Way way() {
        return before.plus(wheels.until(time.nanos()));
    }

    /** Starts again at the start pose, for a new connection. */
    synchronized void begin() {
        reckoning.reset();
        before = Way.NONE;
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
        answered(nanos);
    }

    /** The robot answered a question that was sent at this time; publishes the state. */
    void answered(long askedNanos) {
        reportedNanos = Math.max(reportedNanos, askedNanos);
        states.accept(state());
    }

    private void begin(Wheels next) {
        reckoning.begin(next, next.sinceNanos());
        before = before.plus(wheels.until(next.sinceNanos()));
        wheels = next;
    }

    /** The estimate for now, with the time of the last report. */
    private synchronized BotState state() {
        long now = time.nanos();
        MotorValues values = wheels.values();
        SpeedTable table = wheels.table();
        boolean moving = !values.isStill() || mayMoveUnreported.getAsBoolean();
        return new BotState(
                reckoning.at(now), table.speedMmPerSec(values), table.turnDegPerSec(values), moving, reportedNanos);
    }
}
