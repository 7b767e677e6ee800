package majic.velocity;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DeadReckoning;
import majic.driver.Motion;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The motions of a base during one connection. Velocities are published 20 times a second while the base moves. A stop
 * is published at once and repeated until the odometry shows the base stationary. Of a base without odometry the
 * position is calculated from the velocities sent, and its stop is not confirmed by anything. Thread-safe.
 */
public final class VelocityMotion {
    private static final Logger LOG = System.getLogger(VelocityMotion.class.getName());

    /** Long enough to brake from the highest speed, seconds. */
    private static final double HALT_S = 4;

    /** A stop is repeated for so long if the odometry does not show the base stationary, seconds. */
    private static final double REPEAT_S = 5;

    private static final int LEAST_STOPS = 3;

    /** Between two calculated positions of a base without odometry that has not been commanded for a while, seconds. */
    private static final double IDLE_S = 0.5;

    /** Between two notices about jumps, seconds. */
    private static final double NOTICE_S = 10;

    private final BaseOwner owner;
    private final BaseDynamics dynamics;
    private final ObstructionSource obstructions;
    private final VelocitySender sender;
    private final MovingBase base;
    private final VelocityDrive driving;
    private final OdometryTracker tracker;
    private volatile LastOdometry last;
    private final @Nullable DeadReckoning reckoning;
    private final AtomicBoolean scheduled = new AtomicBoolean();
    private long noticedNanos;
    private int jumpsNoticed;

    /** Where the position of a base comes from. */
    public enum PoseSource {
        /** From its odometry. */
        ODOMETRY,
        /** From the velocities sent: the base reports no odometry. */
        COMMANDS
    }

    /**
     * Creates the motions of a base; sends nothing.
     *
     * @param owner its driver
     * @param output its velocity topic
     * @param dynamics its limits
     * @param before where the base was before its connection was lost
     * @param source whether it has odometry
     */
    public VelocityMotion(
            BaseOwner owner, VelocityOutput output, BaseDynamics dynamics, LastOdometry before, PoseSource source) {
        this.owner = owner;
        this.dynamics = dynamics;
        this.obstructions = owner.obstructions();
        this.sender = new VelocitySender(output, owner.waiting().time(), new Sent());
        this.base = new MovingBase(owner.waiting(), sender, new OdometryDelay(owner::roundTripS), dynamics.accuracy());
        this.driving = new VelocityDrive(base, obstructions, dynamics);
        this.tracker = new OdometryTracker(dynamics, before);
        this.last = before;
        this.reckoning = source == PoseSource.COMMANDS ? new DeadReckoning() : null;
    }

    /**
     * Begins. Sends nothing, except after the loss of a connection while the base moved: a stop, since some bases drive
     * on.
     *
     * @param mayMove whether the base may still move by commands of an earlier connection
     */
    public void begin(boolean mayMove) {
        if (reckoning != null) {
            estimate();
            owner.every("dead reckoning", IDLE_S, this::estimate);
        }
        if (mayMove) {
            sender.stop();
        }
    }

    /**
     * Takes in a reading of the odometry. Called by one thread at a time.
     *
     * @param raw the pose in the frame of the odometry
     * @param mmPerSec the reported speed, ahead positive
     * @param degPerSec the reported turn rate, counterclockwise positive
     * @param measuredNanos when it was measured, which is before its arrival
     */
    public void reported(Pose raw, double mmPerSec, double degPerSec, long measuredNanos) {
        TrackedState now =
                tracker.add(raw, mmPerSec, degPerSec, owner.waiting().time().nanos());
        last = new LastOdometry(now.pose(), raw, now.atNanos());
        boolean moving = !now.stationary() || sender.isMoving();
        owner.publish(new BotState(now.pose(), now.speedMmPerSec(), now.turnRateDegPerSec(), moving, measuredNanos));
        // After publishing: a motion that ends by this state has ended in the published state as well.
        base.set(now, measuredNanos);
        noticeJump(now);
    }

    /**
     * Takes in a message of the odometry that has no pose. A moving base that sends only such messages is stopped, as
     * one whose odometry is silent.
     *
     * @param reason what is wrong with it, as half a sentence
     */
    public void unusable(String reason) {
        base.unusable(reason);
    }

    private void noticeJump(TrackedState now) {
        boolean due = jumpsNoticed == 0 || (now.atNanos() - noticedNanos) / 1e9 > NOTICE_S;
        if (now.jumps() > jumpsNoticed && due) {
            noticedNanos = now.atNanos();
            jumpsNoticed = now.jumps();
            owner.notice("its odometry jumped or was reset; its position goes on from where it was");
        }
    }

    /**
     * Returns where the base was last.
     *
     * @return by the newest reading; as before the connection, if there was none
     */
    public LastOdometry last() {
        return last;
    }

    /** Returns whether there has been a reading. */
    public boolean hasReported() {
        return base.isKnown();
    }

    /**
     * Moves straight.
     *
     * @param mm ahead positive
     * @param cruiseMmPerSec the highest speed, positive
     * @return the distance covered, by the odometry
     * @throws MotionFailed if a contact, the odometry or a lack of progress ended it
     */
    public Value move(double mm, double cruiseMmPerSec, Motion motion) {
        return isReady(motion)
                ? run(Displacement.Straight.of(base.now(), mm, cruiseMmPerSec, dynamics), motion)
                : Value.of(0, Unit.MM);
    }

    /**
     * Turns on the spot; otherwise as {@link #move}.
     *
     * @param degrees counterclockwise positive; full turns count
     * @param cruiseDegPerSec the highest rate, positive
     */
    public Value turn(double degrees, double cruiseDegPerSec, Motion motion) {
        return isReady(motion)
                ? run(Displacement.Turn.of(base.now(), degrees, cruiseDegPerSec, dynamics), motion)
                : Value.of(0, Unit.DEG);
    }

    private Value run(Displacement way, Motion motion) {
        return new OdometryMotion(base, obstructions, way, motion).run();
    }

    /** Lets a base that has only just been stopped come to rest first; false if the guard condition holds already. */
    private boolean isReady(Motion motion) {
        if (motion.pause(0) && sender.isStopping()) {
            motion.await(this::hasSettled, HALT_S);
        }
        return !motion.guardReached();
    }

    /** Sends no more zero velocities after a stop: from now on something else than a velocity moves the base. */
    public void leave() {
        sender.endStop();
    }

    /** Without odometry there is nothing to wait for: the motion fails at once. */
    private boolean hasSettled() {
        return !sender.isStopping() || base.isStationarySince(sender.stopNanos()) || base.silence() != null;
    }

    /**
     * Begins a drive, or changes its velocity; it goes on until {@link #halt}.
     *
     * @throws MotionFailed if the drive has ended by itself; the next call begins a new one
     * @throws LinkLost if the connection has ended
     */
    public void drive(double mmPerSec, double degPerSec) {
        driving.drive(mmPerSec, degPerSec);
    }

    /**
     * Stops the base: publishes a zero velocity at once, and repeats it until the base is stationary.
     *
     * @throws LinkLost if the connection has ended
     */
    public void halt() {
        String reason = driving.stop();
        if (reason != null) {
            owner.notice("the drive ended: " + reason);
        }
    }

    /**
     * Waits until the odometry shows the base stationary after {@link #halt}; of a base without odometry, until the
     * stop has been repeated. Does not wait on a thread that must not.
     *
     * @throws BotException if it is not stationary within 4 s
     * @throws LinkLost if the connection ended meanwhile
     */
    public void confirmHalt() {
        if (WaitPolicy.isAllowed() && !base.awaitStationary(HALT_S)) {
            throw new BotException(owner.name() + " has not come to rest within " + Value.plain(HALT_S)
                    + " s of the stop: " + evidence() + "; stop it at the robot");
        }
    }

    private String evidence() {
        String silence = base.silence();
        if (silence != null) {
            return silence;
        }
        TrackedState now = base.now();
        return String.format(
                Locale.ROOT,
                "its odometry shows %.0f mm/s and %.0f deg/s",
                now.speedMmPerSec(),
                now.turnRateDegPerSec());
    }

    /** Returns whether the base moves by its odometry, or has been sent a velocity that is in force. */
    public boolean isMoving() {
        return sender.isMoving() || (base.isKnown() && !base.now().stationary());
    }

    /**
     * Ends in order, while there is still a connection: the stop of a base that was moved is repeated first, since the
     * timer of the robot has ended by now. Takes 0.1 s at most.
     */
    public void close() {
        for (int stop = 1; sender.isActive() && stop < LEAST_STOPS; stop++) {
            owner.waiting().awaitClosing(base::hasEnded, VelocitySender.PERIOD_S);
            try {
                sender.send(0, 0);
            } catch (LinkLost e) {
                LOG.log(Level.DEBUG, "the last stop was not sent", e);
                break;
            }
        }
        end();
    }

    /** Ends all waiting and sends nothing any more: the connection has ended. */
    public void end() {
        sender.end();
        base.end();
    }

    /**
     * Returns what a base does whose connection was lost, as the second half of a sentence.
     *
     * @return beginning with a semicolon; empty for a base that did not move
     */
    public String afterLoss() {
        if (!isMoving()) {
            return "";
        }
        double timeoutS = dynamics.timeoutS();
        if (Double.isNaN(timeoutS)) {
            return "; the robot may still be moving, since it is not known whether it stops by itself: stop it by hand";
        }
        return Double.isInfinite(timeoutS)
                ? "; the robot may still be moving, since it keeps its last velocity: stop it by hand"
                : "; the robot stops by itself " + Value.plain(timeoutS) + " s after the last command";
    }

    private void schedule() {
        if (scheduled.compareAndSet(false, true)) {
            owner.once("velocity", VelocitySender.PERIOD_S, this::tick);
        }
    }

    private void tick() {
        scheduled.set(false);
        try {
            if (reckoning != null) {
                estimate();
            }
            driving.step();
            endStop();
            sender.repeat();
        } finally {
            if (sender.isActive()) {
                schedule();
            }
        }
    }

    private void endStop() {
        boolean repeated = sender.isStopping() && sender.stopsSent() >= LEAST_STOPS;
        long stopNanos = sender.stopNanos();
        if (repeated && (base.isStationarySince(stopNanos) || base.time().secondsSince(stopNanos) > REPEAT_S)) {
            sender.endStop();
        }
    }

    private void estimate() {
        DeadReckoning estimating = reckoning;
        if (estimating != null && !base.hasEnded()) {
            long now = base.time().nanos();
            reported(estimating.at(now), sender.mmPerSec(), sender.degPerSec(), now);
        }
    }

    /** Handles the velocities that are sent. */
    private final class Sent implements VelocitySender.Listener {
        @Override
        public void begins() {
            base.begin();
        }

        @Override
        public void sent(double mmPerSec, double degPerSec) {
            DeadReckoning estimating = reckoning;
            if (estimating != null) {
                long from = base.time().nanos();
                estimating.begin(
                        (start, at) -> start.after(mmPerSec * (at - from) / 1e9, degPerSec * (at - from) / 1e9), from);
            }
            schedule();
        }
    }
}
