package majic.drivertest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.bot.Value;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** What the conformance tests are made of: the robot of one test, motions on threads of their own, and comparisons. */
abstract class RobotTest {
    static final double SETTLED_MM = 3;
    private static final double SETTLED_DEG = 1.5;
    static final double SMALL_MM = 15;
    static final double SMALL_DEG = 5;

    /** The longest that a stop may take, and a loss to be noticed, s. */
    static final double PROMPT_S = 3;

    /** The longest that a motion may take here, s. */
    private static final double LONGEST_S = 120;

    TestedRobot robot;
    MajicBot bot;

    /**
     * Makes a robot and its driver for one test.
     *
     * @return not connected; the calling thread, which is that of the test, uses its clock
     */
    protected abstract TestedRobot newRobot();

    /**
     * Returns the length of the motions.
     *
     * @return mm, within {@code maxMove} twice
     */
    protected double moveMm() {
        return 300;
    }

    /**
     * Returns how far a motion or a reading may be from the true one.
     *
     * @return a part of it, such as 0.1
     */
    protected double tolerance() {
        return 0.1;
    }

    /**
     * Returns how far the robot may go on behind a stop.
     *
     * @return mm
     */
    protected double brakingMm() {
        return 100;
    }

    /**
     * Returns within which time the driver reports the connection as lost if the robot sends nothing, moving or not.
     *
     * @return seconds, as the page about the robot states them
     */
    protected double lostWithinS() {
        return PROMPT_S;
    }

    /**
     * Returns whether a motion that an obstacle prevents fails. Override this for a robot that cannot notice it; its
     * motion must end nevertheless.
     *
     * @return true unless overridden
     */
    protected boolean noticesObstacles() {
        return true;
    }

    /**
     * Returns the parameters of sensors that must have readings when {@code connect()} returns.
     *
     * @return names, such as {@code distanceFront}
     */
    protected List<String> sensors() {
        return List.of();
    }

    /** Called by JUnit before each test. */
    @BeforeEach
    final void makeRobot() {
        robot = newRobot();
        bot = robot.bot();
    }

    /** Called by JUnit after each test. */
    @AfterEach
    final void closeRobot() {
        robot.close();
    }

    /** A motion on a thread of its own. */
    final class Running implements Runnable {
        private final Supplier<MotionReport> motion;
        private final Signal changes = bot.time().signal();
        final Thread thread = bot.time().thread("motion", this);
        private volatile boolean over;
        private volatile @Nullable Throwable thrown;

        Running(Supplier<MotionReport> motion) {
            this.motion = motion;
        }

        @Override
        public void run() {
            try {
                motion.get();
            } catch (RuntimeException | Error e) {
                thrown = e;
            } finally {
                over = true;
                changes.raise();
            }
        }

        /** Waits for the end; returns what it threw, or null. */
        @Nullable
        Throwable end() {
            await(changes, () -> over, LONGEST_S, "the motion does not end");
            return thrown;
        }
    }

    /** Begins a motion on a thread of its own; returns when the driver has it, or it waits for another one. */
    Running begin(Supplier<MotionReport> motion) {
        Running running = new Running(motion);
        running.thread.start();
        pass(0.05);
        return running;
    }

    /** Waits until the robot has gone a part of the way. */
    final void awaitMotion() {
        Pose start = robot.truePose();
        double deadline = seconds() + LONGEST_S;
        while (start.distanceMm(robot.truePose()) < moveMm() / 4) {
            assertTrue(seconds() < deadline, "the robot does not move");
            pass(0.02);
        }
    }

    final void pass(double seconds) {
        try {
            bot.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError("interrupted", e);
        }
    }

    private static void await(Signal changes, BooleanSupplier condition, double seconds, String otherwise) {
        try {
            assertTrue(changes.await(condition, seconds), otherwise);
        } catch (InterruptedException e) {
            throw new AssertionError("interrupted", e);
        }
    }

    final double seconds() {
        return bot.time().nanos() / 1e9;
    }

    final void assertStaysAt(Pose place, double seconds) {
        pass(seconds);
        Pose now = robot.truePose();
        assertTrue(
                place.distanceMm(now) <= SETTLED_MM && Math.abs(turnedDeg(place, now)) <= SETTLED_DEG,
                "the robot has moved from " + place + " to " + now + " within " + seconds + " s");
    }

    final void assertNear(double expected, double actual, double small, String what) {
        double allowed = small + tolerance() * Math.abs(expected);
        assertEquals(expected, actual, allowed, what);
    }

    static void assertWithin(double least, double most, double actual, String what) {
        assertTrue(least <= actual && actual <= most, actual + " " + what + ", expected " + least + " to " + most);
    }

    /** How far one pose is ahead of another, along the heading of the latter. */
    static double aheadMm(Pose from, Pose to) {
        double heading = Math.toRadians(from.headingDeg());
        return (to.xMm() - from.xMm()) * Math.cos(heading) + (to.yMm() - from.yMm()) * Math.sin(heading);
    }

    static double turnedDeg(Pose from, Pose to) {
        return Pose.normalised(to.headingDeg() - from.headingDeg());
    }

    static double number(MotionReport report) {
        Value amount = report.amount();
        return amount == null ? Double.NaN : amount.number();
    }
}
