package majic.velocity;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import majic.bot.Pose;

/**
 * A base behind a connection with delays: obeys velocities within its own limits, and reports its odometry. Stepped by
 * the test's clock, one millisecond at a time. Commands may come from any thread.
 */
final class BaseModel {
    private static final double STEP_S = 0.001;

    final Traits traits;
    private final Consumer<Reading> odometry;
    private final Deque<Command> underWay = new ArrayDeque<>();
    private final Deque<Reading> reports = new ArrayDeque<>();
    private final List<Command> received = new ArrayList<>();
    private Pose pose = Pose.START;
    private double wantedMmPerSec;
    private double wantedDegPerSec;
    private double mmPerSec;
    private double degPerSec;
    private long nowMs;
    private long commandedMs;
    volatile Pose frame = new Pose(1500, -700, 130);
    volatile boolean blocked;
    volatile boolean silent;
    volatile boolean deaf;

    /** A velocity, and when it was sent, ms. */
    record Command(double mmPerSec, double degPerSec, long atMs) {
        boolean isZero() {
            return mmPerSec == 0 && degPerSec == 0;
        }
    }

    /** A message of the odometry, and when it was made, ms. */
    record Reading(Pose raw, double mmPerSec, double degPerSec, long atMs) {}

    /**
     * How a base differs from an ideal one.
     *
     * @param periodMs from one odometry message to the next
     * @param delayMs each way
     * @param steps the speed is cut to whole hundredths of m/s and rad/s, as of a TurtleBot3
     * @param leastMmPerSec lower speeds have no effect
     * @param acceleration of its own ramp, mm/s²
     * @param timeoutMs stops by itself; 0 for never
     * @param velocities whether the odometry has velocities
     * @param roundTripMs what pings measure of the delays; 0 for a base whose own nodes are that slow
     */
    record Traits(
            int periodMs,
            int delayMs,
            boolean steps,
            double leastMmPerSec,
            double acceleration,
            int timeoutMs,
            boolean velocities,
            int roundTripMs) {
        static final Traits USUAL = new Traits(33, 25, false, 0, 2000, 500, true, 0);

        Traits reporting(int newPeriodMs, int newDelayMs) {
            return new Traits(
                    newPeriodMs, newDelayMs, steps, leastMmPerSec, acceleration, timeoutMs, velocities, roundTripMs);
        }

        Traits measured() {
            return new Traits(
                    periodMs, delayMs, steps, leastMmPerSec, acceleration, timeoutMs, velocities, 2 * delayMs);
        }

        Traits inSteps() {
            return new Traits(periodMs, delayMs, true, leastMmPerSec, acceleration, timeoutMs, velocities, roundTripMs);
        }

        Traits sticking(double leastSpeed) {
            return new Traits(periodMs, delayMs, steps, leastSpeed, acceleration, timeoutMs, velocities, roundTripMs);
        }

        Traits heavy(double newAcceleration) {
            return new Traits(
                    periodMs, delayMs, steps, leastMmPerSec, newAcceleration, timeoutMs, velocities, roundTripMs);
        }

        Traits drivingOn() {
            return new Traits(periodMs, delayMs, steps, leastMmPerSec, acceleration, 0, velocities, roundTripMs);
        }

        Traits withoutVelocities() {
            return new Traits(periodMs, delayMs, steps, leastMmPerSec, acceleration, timeoutMs, false, roundTripMs);
        }
    }

    BaseModel(Traits traits, Consumer<Reading> odometry) {
        this.traits = traits;
        this.odometry = odometry;
    }

    synchronized void command(double newMmPerSec, double newDegPerSec) {
        Command sent = new Command(newMmPerSec, newDegPerSec, nowMs);
        received.add(sent);
        underWay.add(sent);
    }

    /** Everything that was published. */
    synchronized List<Command> received() {
        return List.copyOf(received);
    }

    synchronized Pose truePose() {
        return pose;
    }

    synchronized double mmPerSec() {
        return mmPerSec;
    }

    synchronized long nowMs() {
        return nowMs;
    }

    /** Lets a millisecond pass, and delivers the readings that arrive. */
    void step() {
        List<Reading> arrived = move();
        if (!silent) {
            arrived.forEach(odometry);
        }
    }

    private synchronized List<Reading> move() {
        nowMs++;
        while (!underWay.isEmpty() && underWay.peek().atMs() + traits.delayMs() <= nowMs) {
            obey(underWay.remove());
        }
        if (traits.timeoutMs() > 0 && nowMs - commandedMs > traits.timeoutMs()) {
            wantedMmPerSec = 0;
            wantedDegPerSec = 0;
        }
        mmPerSec = follow(mmPerSec, wantedMmPerSec, traits.acceleration());
        degPerSec = follow(degPerSec, wantedDegPerSec, traits.acceleration() / 2);
        if (blocked) {
            mmPerSec = 0;
            degPerSec = 0;
        }
        pose = pose.after(mmPerSec * STEP_S, degPerSec * STEP_S);
        if (nowMs % traits.periodMs() == 0) {
            double scale = traits.velocities() ? 1 : 0;
            reports.add(new Reading(frame.plus(pose), scale * mmPerSec, scale * degPerSec, nowMs));
        }
        List<Reading> arrived = new ArrayList<>();
        while (!reports.isEmpty() && reports.peek().atMs() + traits.delayMs() <= nowMs) {
            arrived.add(reports.remove());
        }
        return arrived;
    }

    private void obey(Command command) {
        if (deaf) {
            return;
        }
        commandedMs = nowMs;
        wantedMmPerSec = effective(stepped(command.mmPerSec(), 10), traits.leastMmPerSec());
        wantedDegPerSec = effective(stepped(command.degPerSec(), Math.toDegrees(0.01)), traits.leastMmPerSec() / 4);
    }

    private double stepped(double velocity, double step) {
        // The tiny amount keeps whole steps whole in spite of rounding.
        return traits.steps() ? (long) (velocity / step + Math.signum(velocity) * 1e-9) * step : velocity;
    }

    private static double effective(double velocity, double least) {
        return Math.abs(velocity) < least ? 0 : velocity;
    }

    private static double follow(double from, double to, double perSec2) {
        double most = perSec2 * STEP_S;
        return from + Math.max(-most, Math.min(most, to - from));
    }
}
