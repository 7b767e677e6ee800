package majic.velocity;

import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.Range;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.ros.RosType;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** A driver that has nothing but the motions, and is connected to a {@link BaseModel}. */
final class ModelDriver extends BotDriver {
    static final double FASTEST_MM_PER_SEC = 220;
    static final double FASTEST_DEG_PER_SEC = 160;

    private final BaseDynamics dynamics;
    private final VelocityMotion.PoseSource source;
    private final Owner owner = new Owner();
    volatile @Nullable BaseModel base;
    volatile @Nullable VelocityMotion motions;
    volatile @Nullable Obstruction obstruction;
    volatile double lateS;
    private volatile @Nullable BotState state;
    private volatile boolean wasMoving;
    private volatile LastOdometry last = LastOdometry.NONE;

    ModelDriver(TimeSource time, double timeoutS, VelocityMotion.PoseSource source) {
        super(new RosType(), size(), new BotEnvironment(time, Settings.inMemory()));
        this.dynamics = BaseDynamics.of(FASTEST_MM_PER_SEC, FASTEST_DEG_PER_SEC, timeoutS);
        this.source = source;
    }

    private static BotProfile size() {
        return new BotProfile(
                105,
                new Range(-FASTEST_MM_PER_SEC, FASTEST_MM_PER_SEC),
                new Range(-FASTEST_DEG_PER_SEC, FASTEST_DEG_PER_SEC),
                150,
                45,
                100,
                false);
    }

    /** Receives a message of the odometry. */
    void received(BaseModel.Reading reading) {
        VelocityMotion now = motions;
        if (now != null && source == VelocityMotion.PoseSource.ODOMETRY) {
            now.reported(reading.raw(), reading.mmPerSec(), reading.degPerSec(), measuredNanos());
        }
    }

    /** The readings are as old as the delay of the connection, as far as it is measured, and this test's own. */
    private long measuredNanos() {
        return time().nanos() - (long) (lateS * 1e9);
    }

    /** Ends the connection. */
    void cut() {
        VelocityMotion now = motions;
        if (now != null && isConnected()) {
            wasMoving = now.isMoving();
            String after = now.afterLoss();
            last = now.last();
            motions = null;
            now.end();
            lost(new LinkLost("the bridge closed the connection" + after));
        }
    }

    private VelocityMotion motions() {
        VelocityMotion now = motions;
        if (now == null) {
            throw new LinkLost("not connected");
        }
        return now;
    }

    private BaseModel base() {
        BaseModel there = base;
        if (there == null || motions == null) {
            throw new LinkLost("not connected");
        }
        return there;
    }

    @Override
    protected void open() {
        VelocityMotion opened = new VelocityMotion(owner, owner, dynamics, last, source);
        motions = opened;
        opened.begin(wasMoving);
        owner.waiting().awaitConnecting(opened::hasReported, 3);
    }

    @Override
    protected void shut() {
        VelocityMotion now = motions;
        if (now != null) {
            now.close();
        }
        motions = null;
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        return motions().move(mm, cruiseMmPerSec(), motion);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        return motions().turn(degrees, cruiseTurnDegPerSec(), motion);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        motions().drive(mmPerSec, degPerSec);
    }

    @Override
    protected void halt() {
        motions().halt();
    }

    @Override
    public void confirmHalt() {
        motions().confirmHalt();
    }

    /** The driver as its motions use it. */
    private final class Owner implements BaseOwner, VelocityOutput {
        @Override
        public String name() {
            return ModelDriver.this.name();
        }

        @Override
        public RobotWait waiting() {
            return ModelDriver.this.waiting();
        }

        @Override
        public ObstructionSource obstructions() {
            return () -> obstruction;
        }

        @Override
        public double roundTripS() {
            BaseModel there = base;
            return there == null ? 0 : there.traits.roundTripMs() / 1e3;
        }

        @Override
        public void once(String what, double seconds, Runnable task) {
            ModelDriver.this.once(what, seconds, task);
        }

        @Override
        public void every(String what, double seconds, Runnable task) {
            ModelDriver.this.every(what, seconds, task);
        }

        @Override
        public void publish(BotState newState) {
            ModelDriver.this.publish(newState);
        }

        @Override
        public void notice(String message) {
            ModelDriver.this.notice(message);
        }

        @Override
        public void publish(double mmPerSec, double degPerSec) {
            base().command(mmPerSec, degPerSec);
        }
    }
}
