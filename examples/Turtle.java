import java.util.List;
import majic.bot.Beam;
import majic.bot.BotAddress;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;

/** A complete robot type of one's own: a turtle that exists only in memory, and sees a wall 1 m ahead of its start. */
public final class Turtle extends BotDriver {
    private static final double WALL_X_MM = 1000;
    private static final RangeSensor EYE = new RangeSensor("eye", List.of(new Beam(Pose.START, 1, 0, 2000, 1)));

    private volatile double speedMmPerSec;
    private volatile double turnDegPerSec;
    private volatile boolean penDown;
    private volatile Pose pose = Pose.START;

    /** Registers the robot type with MAJIC. */
    public static final class Type implements BotType {
        @Override
        public String name() {
            return "turtle";
        }

        @Override
        public String label() {
            return "Turtle";
        }

        @Override
        public String make() {
            return "Example Turtle";
        }

        @Override
        public List<Reach> reaches() {
            return List.of(Reach.TCP);
        }

        @Override
        public int defaultPort(String scheme) {
            return 4000;
        }

        @Override
        public MajicBot create(BotAddress address, BotEnvironment environment) {
            return new Turtle(this, environment);
        }

        @Override
        public String advice() {
            return "A turtle is always there.";
        }
    }

    Turtle(BotType type, BotEnvironment environment) {
        super(type, new BotProfile(80, new Range(-200, 200), new Range(-90, 90), 100, 45, 100, true), environment);
        table().add(Parameter.onOff("pen", "whether it draws"), () -> Value.onOff(penDown))
                .writes(values -> penDown = values.get(0).isYes());
    }

    @Override
    public List<RangeSensor> rangeSensors() {
        return List.of(EYE);
    }

    @Override
    protected void open() {
        report();
    }

    @Override
    protected void shut() {
        halt();
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        motion.send(() -> wheels(Math.signum(mm) * cruiseMmPerSec(), 0));
        motion.pause(Math.abs(mm) / cruiseMmPerSec());
        motion.send(this::halt);
        double gone = Math.signum(mm) * Math.min(Math.abs(mm), motion.seconds() * cruiseMmPerSec());
        pose = pose.after(gone, 0);
        report();
        return Value.about(gone, Unit.MM);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        motion.send(() -> wheels(0, Math.signum(degrees) * cruiseTurnDegPerSec()));
        motion.pause(Math.abs(degrees) / cruiseTurnDegPerSec());
        motion.send(this::halt);
        double turned = Math.signum(degrees) * Math.min(Math.abs(degrees), motion.seconds() * cruiseTurnDegPerSec());
        pose = pose.after(0, turned);
        report();
        return Value.about(turned, Unit.DEG);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        wheels(mmPerSec, degPerSec);
    }

    @Override
    protected void halt() {
        wheels(0, 0);
    }

    private void wheels(double mmPerSec, double degPerSec) {
        speedMmPerSec = mmPerSec;
        turnDegPerSec = degPerSec;
        report();
    }

    private void report() {
        boolean moving = speedMmPerSec != 0 || turnDegPerSec != 0;
        publish(new BotState(pose, speedMmPerSec, turnDegPerSec, moving, time().nanos()));
        if (hasScanListeners()) {
            publishScan(new RangeScan(EYE, time().nanos() / 1e9, pose, (float) wallMm(pose)));
        }
    }

    private static double wallMm(Pose eye) {
        double mm = (WALL_X_MM - eye.xMm()) / Math.cos(Math.toRadians(eye.headingDeg()));
        return mm >= 0 ? mm : Double.POSITIVE_INFINITY;
    }
}
