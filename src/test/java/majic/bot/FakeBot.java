package majic.bot;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.driver.BotDriver;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A robot that is made up for tests. It moves at its cruise speed on its own clock, reads every 100 ms, and keeps a
 * list of what was sent to it.
 */
public final class FakeBot extends BotDriver {
    private static final double READING_S = 0.1;

    private final List<String> sent = new CopyOnWriteArrayList<>();
    private final Map<String, Value> told = new ConcurrentHashMap<>();
    private volatile double ahead = Double.POSITIVE_INFINITY;
    private volatile double headPanDeg;
    private volatile boolean light;
    private volatile double stallAfterMm = Double.POSITIVE_INFINITY;
    private volatile @Nullable RuntimeException refusal;
    private volatile double connectSeconds;
    private volatile @Nullable String identity;
    private volatile boolean stuck;
    private volatile boolean handsGuardsOver;
    private volatile boolean haltsBadly;
    private volatile double confirmSeconds;
    private volatile Pose pose = Pose.START;
    private volatile List<RangeSensor> sensors = List.of();
    private volatile Runnable lineIsSlow = () -> {};
    private volatile Runnable toldAhead = () -> {};

    /** A robot on a clock. */
    public FakeBot(BotType type, BotEnvironment environment) {
        super(
                type,
                new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 300, 90, 500, false),
                environment);
        table().add(
                        Parameter.number("distanceFront", Unit.MM, "what is ahead"),
                        () -> told("distanceFront", Double.isInfinite(ahead) ? Value.CLEAR : Value.of(ahead, Unit.MM)));
        table().add(
                        Parameter.number("headPan", Unit.DEG, "where the head looks, left positive")
                                .within(-91, 91)
                                .with(Parameter.number("time", Unit.S, "how long it takes")
                                        .within(0, 10)),
                        () -> Value.of(headPanDeg, Unit.DEG))
                .moves((values, motion) -> motion.send(() -> {
                    sent.add("headPan " + Value.plain(values.get(0).number()));
                    headPanDeg = values.get(0).number();
                }));
        table().add(Parameter.onOff("light", "to find out which one it is"), () -> Value.onOff(light))
                .writes(values -> light = values.get(0).isYes());
        table().add(
                        Parameter.number("voltage", Unit.V, "of the battery"),
                        () -> told("voltage", Value.of(12.6, Unit.V)));
        table().add(
                        Parameter.yesNo("bumped", "whether it touches something"),
                        () -> told("bumped", Value.yesNo(false)));
        settable(Parameter.choice("posture", List.of("stand", "sit"), "how it stands"), Value.text("stand"));
        settable(Parameter.text("title", "what is written on it"), Value.text(""));
        add(new DriverCommand(
                "wag",
                List.of(Parameter.number("times", Unit.NONE, "how often").within(1, 10)),
                true,
                "wags the tail",
                (arguments, motion) -> "wagged " + arguments.get(0)));
        Parameter time = Parameter.number("time", Unit.MS, "how long").within(0, 1000);
        add(new DriverCommand(
                "bark",
                List.of(Parameter.choice("mood", List.of("gladly", "sadly"), "how"), time),
                List.of(time),
                false,
                "barks with pauses",
                (arguments, motion) -> "barked " + arguments));
    }

    private void settable(Parameter parameter, Value first) {
        table().add(parameter, () -> told(parameter.name(), first))
                .writes(values -> told.put(parameter.name(), values.get(0)));
    }

    private Value told(String parameter, Value otherwise) {
        return told.getOrDefault(parameter, otherwise);
    }

    /** Sets what distinguishes the robot. */
    public void identity(String newIdentity) {
        identity = newIdentity;
    }

    @Override
    public Optional<String> identity() {
        return Optional.ofNullable(identity);
    }

    /** Gives the robot a further parameter, which always has this value, whatever it is set to. */
    public void equip(Parameter parameter, Value value) {
        table().add(parameter, () -> value).writes(values -> {});
    }

    /** Makes the robot report a reading. */
    public void tell(String parameter, Value value) {
        told.put(parameter, value);
        publish(state());
    }

    /** A fake robot of a fake type, ready to connect. */
    public static FakeBot on(TimeSource time) {
        return new FakeBot(new FakeType(), new BotEnvironment(time, Settings.inMemory()));
    }

    /** What was sent so far, in order. */
    public List<String> sent() {
        return List.copyOf(sent);
    }

    /** Returns how often this was sent so far. */
    public long count(String command) {
        return sent.stream().filter(command::equals).count();
    }

    /** How far the next thing ahead is, mm; shrinks as the robot drives. */
    public void putObstacle(double mm) {
        ahead = mm;
    }

    /** Makes the next moves stall after a distance, mm. */
    public void stallAfter(double mm) {
        stallAfterMm = mm;
    }

    /** Makes connecting fail. */
    public void refuse(BotException problem) {
        refusal = problem;
    }

    /** Makes connecting throw an error that drivers should not throw; null ends that. */
    public void breakDownWhileConnecting(@Nullable RuntimeException mistake) {
        refusal = mistake;
    }

    /** Makes connecting take time. */
    public void connectIn(double seconds) {
        connectSeconds = seconds;
    }

    /** Makes the robot's line take nothing any more, without saying so. */
    public void getStuck() {
        stuck = true;
    }

    /** Makes the robot take the guards of its moves as texts, without obeying them. */
    public void handsGuardsOver() {
        handsGuardsOver = true;
    }

    /** Makes the sending of a drive take as long as this does. */
    public void sendDrivesThrough(Runnable line) {
        lineIsSlow = line;
    }

    /** Makes the robot's line take data again. */
    public void comeLoose() {
        stuck = false;
    }

    /** Sets the action that runs at each stop sent ahead of the ordinary one. */
    public void whenStoppedAhead(Runnable told) {
        toldAhead = told;
    }

    /** Makes it take a while until a stop is confirmed. */
    public void standAfter(double seconds) {
        confirmSeconds = seconds;
    }

    /** Makes stopping fail as no driver should. */
    public void breakDownWhenHalted() {
        haltsBadly = true;
    }

    @Override
    public List<String> calibration() {
        return List.of("posture");
    }

    /** Cuts the robot's line. */
    public void cut() {
        lost(new LinkLost("connection lost"));
    }

    @Override
    protected void open() {
        try {
            time().sleep(connectSeconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        RuntimeException problem = refusal;
        if (problem != null) {
            throw problem;
        }
        report(0, false);
    }

    @Override
    protected void shut() {
        sent.add("close");
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        if (handsGuardsOver) {
            motion.handOverGuard(until -> true).ifPresent(until -> sent.add("until " + until));
        }
        double goal = Math.min(Math.abs(mm), stallAfterMm);
        double speed = Math.copySign(cruiseMmPerSec(), mm);
        motion.send(() -> sent.add("move " + Value.plain(mm)));
        double done = 0;
        while (done < goal && motion.pause(Math.min(READING_S, (goal - done) / cruiseMmPerSec()))) {
            double step = Math.min(READING_S * cruiseMmPerSec(), goal - done);
            done += step;
            ahead -= Math.copySign(step, mm);
            pose = pose.after(Math.copySign(step, mm), 0);
            report(speed, true);
        }
        report(0, false);
        if (stallAfterMm < Math.abs(mm)) {
            throw new MotionFailed("stalled after " + Value.plain(done) + " mm");
        }
        return Value.of(Math.copySign(done, mm), Unit.MM);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        motion.send(() -> sent.add("turn " + Value.plain(degrees)));
        motion.pause(Math.abs(degrees) / cruiseTurnDegPerSec());
        pose = pose.after(0, degrees);
        report(0, false);
        return Value.of(degrees, Unit.DEG);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        lineIsSlow.run();
        sent.add("drive " + Value.plain(mmPerSec) + " " + Value.plain(degPerSec));
    }

    @Override
    protected void halt() {
        sent.add("halt");
        if (haltsBadly) {
            throw new IllegalStateException("a mistake in the driver");
        }
    }

    @Override
    protected void haltAhead() {
        toldAhead.run();
    }

    @Override
    public void confirmHalt() {
        if (confirmSeconds > 0) {
            confirmSlowly();
        }
        if (stuck) {
            throw new LinkLost("takes no more data");
        }
    }

    private void confirmSlowly() {
        try {
            time().sleep(confirmSeconds);
            sent.add("stands");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Makes the robot report a speed, mm/s. */
    public void reportSpeed(double speed) {
        report(speed, speed != 0);
    }

    private void report(double speed, boolean moving) {
        publish(new BotState(pose, speed, 0, moving, time().nanos()));
    }

    /** Gives it a range sensor. */
    public void equip(RangeSensor sensor) {
        sensors = List.of(sensor);
    }

    @Override
    public List<RangeSensor> rangeSensors() {
        return sensors;
    }

    /** Whether something asks for scans. */
    public boolean isAskedForScans() {
        return hasScanListeners();
    }

    /** Measures: it is where the odometry of the scan has it. */
    public void measure(RangeScan scan) {
        pose = scan.odometry();
        publish(new BotState(pose, 0, 0, false, time().nanos()));
        if (hasScanListeners()) {
            publishScan(scan);
        }
    }
}
