package majic.driver;

import java.util.Objects;
import java.util.Optional;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.Course;
import majic.bot.DriveGuard;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The part of a driver that moves its robot: motions one after the other, each under a permit and within the limits,
 * and the stop, which overtakes them. The hooks that {@link MotionGate} calls for them are implemented for each robot.
 */
abstract class MovingRobot extends MajicBot {
    private final RobotWait waiting;
    private final Readings readings;
    private final RobotTimer timer;
    private final GuardedDriving guarding = new GuardedDriving(this);
    private final MotionGate gate;
    private volatile MotionLimits limits;

    /**
     * A robot that is not connected; starts no thread.
     *
     * @param profile its size and pace
     * @param time its clock
     */
    MovingRobot(BotProfile profile, TimeSource time) {
        this.limits = new MotionLimits(Objects.requireNonNull(profile, "profile"));
        this.waiting = new RobotWait(time, time.signal());
        this.readings = new Readings(changes());
        this.timer = new RobotTimer(time);
        this.gate = new MotionGate(this, timer, guarding);
    }

    @Override
    public final MotionReport move(double mm, Guard until) {
        return move(mm, until, permit());
    }

    final MotionReport move(double mm, Guard until, Permit permit) {
        limits.checkMove(mm);
        return gate.guarded(until, permit, mm, () -> guarding.endOfMove(mm), motion -> moveBy(mm, motion));
    }

    @Override
    public final MotionReport turn(double degrees, Guard until) {
        return turn(degrees, until, permit());
    }

    final MotionReport turn(double degrees, Guard until, Permit permit) {
        limits.checkTurn(degrees);
        return gate.guarded(until, permit, 0, () -> guarding.endOfDrive(0, degrees), motion -> turnBy(degrees, motion));
    }

    @Override
    public final MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until) {
        return drive(mmPerSec, degPerSec, seconds, until, permit());
    }

    final MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until, Permit permit) {
        limits.checkDrive(mmPerSec, degPerSec, seconds);
        return gate.drive(mmPerSec, degPerSec, seconds, until, permit);
    }

    @Override
    public final MotionReport follow(Course course, Guard until) {
        return follow(course, until, permit());
    }

    final MotionReport follow(Course course, Guard until, Permit permit) {
        return gate.follow(course, until, permit);
    }

    @Override
    public final void drive(double mmPerSec, double degPerSec) {
        drive(mmPerSec, degPerSec, false, permit());
    }

    /**
     * Drives until it is not renewed.
     *
     * @param guarded whether the drive is guarded though the parameter {@code guard} is off
     * @return the share of the speeds with which it is driven now
     */
    final double drive(double mmPerSec, double degPerSec, boolean guarded, Permit permit) {
        limits.checkDrive(mmPerSec, degPerSec);
        return gate.drive(mmPerSec, degPerSec, guarded || limits.isGuarded(), permit);
    }

    @Override
    public final void useGuard(@Nullable DriveGuard guard) {
        guarding.use(guard);
    }

    @Override
    public final boolean canBeGuarded() {
        return guarding.isPossible();
    }

    @Override
    public final Optional<String> heldBack() {
        return gate.heldBack();
    }

    @Override
    public final void stop() {
        revokeMotions();
        if (isConnected()) {
            sendStop();
        } else {
            changes().raise();
        }
    }

    /**
     * Revokes the permission to move of all current motions; does not block, sends nothing. Wakes no thread that waits
     * in a motion: {@link #writeStop()} does, so that those threads do not delay the stops of other robots.
     */
    public final void revokeMotions() {
        gate.revoke(() -> new MotionStopped("stopped"));
    }

    /**
     * Sends the stop and waits until the robot has confirmed it. Unlike {@link #stop()} it revokes no permission to
     * move: for callers that have already revoked the relevant permit.
     *
     * @throws LinkLost if the connection was lost: the stop cannot be sent, so the robot must not be reported as
     *     stopped
     * @throws BotException if the robot is being reconnected, or reconnecting failed; the stop cannot be sent then
     *     either
     */
    public final void sendStop() {
        if (writeStop()) {
            confirmHalt();
        }
    }

    /**
     * The part of {@link #sendStop()} that writes; then wakes the threads that wait in motions.
     *
     * @return false for a robot that needs no stop, not connected yet or closed
     */
    public final boolean writeStop() {
        try {
            refuseLost();
            Connection now = connection();
            if (now == Connection.CONNECTING || now == Connection.LOST) {
                throw new BotException(name() + " is not connected, so no stop can reach it");
            }
            boolean open = isConnected();
            if (open) {
                gate.writeStop();
            }
            return open;
        } finally {
            changes().raise();
        }
    }

    @Override
    public final void checkMove(double mm) {
        limits.checkMove(mm);
    }

    @Override
    public final void checkTurn(double degrees) {
        limits.checkTurn(degrees);
    }

    @Override
    public final void checkDrive(double mmPerSec, double degPerSec, double seconds) {
        limits.checkDrive(mmPerSec, degPerSec, seconds);
    }

    /** Ends all motions and permits no others; does not block, sends nothing. */
    final void revokeForGood(String reason) {
        gate.close(() -> new BotException(reason));
        changes().raise();
    }

    @Override
    public final BotProfile profile() {
        return limits.profile();
    }

    /**
     * Replaces the size and pace by those read from the robot itself.
     *
     * @param better the new profile; default for cruise and near unless they have been set
     */
    protected final void profile(BotProfile better) {
        limits = limits.fittedTo(better);
        limits.describe(table());
    }

    /**
     * Sets the parameter {@code maxMove}, for a robot that keeps this limit itself.
     *
     * @param mm the longest single move that is accepted, positive
     */
    protected final void maxMove(double mm) {
        limits.maxMove(mm);
    }

    /**
     * Returns the speed for {@code move}.
     *
     * @return mm/s, positive
     */
    protected final double cruiseMmPerSec() {
        return limits.cruiseMmPerSec();
    }

    /**
     * Returns the rate for {@code turn}.
     *
     * @return deg/s, positive
     */
    protected final double cruiseTurnDegPerSec() {
        return limits.cruiseTurnDegPerSec();
    }

    @Override
    public final TimeSource time() {
        return waiting.time();
    }

    /**
     * Returns the signal that all threads waiting for this robot wait on. Drivers raise it after any change a thread
     * may wait for.
     *
     * @return the signal
     */
    protected final Signal changes() {
        return waiting.changes();
    }

    /**
     * Returns how the driver waits for what its reader or its timer brings about.
     *
     * @return waits on this robot's clock for {@link #changes()}
     */
    protected final RobotWait waiting() {
        return waiting;
    }

    /**
     * Runs a task periodically on the robot's own timer thread, from now until the robot is closed.
     *
     * @param what the name of the task; a task of the same name is replaced
     * @param seconds the period
     * @param task quick; failures are logged
     */
    public final void every(String what, double seconds, Runnable task) {
        timer.every(what, seconds, task);
    }

    /**
     * Runs a task once on the robot's own timer thread, unless the robot is closed before.
     *
     * @param what the name of the task; a task of the same name is replaced
     * @param seconds when, from now
     * @param task quick; failures are logged; may call this method again
     */
    protected final void once(String what, double seconds, Runnable task) {
        timer.once(what, seconds, task);
    }

    /**
     * Returns whether a {@link #drive(double, double)} is in progress.
     *
     * @return true from a drive until it expires or is ended
     */
    protected final boolean isDriving() {
        return gate.isDriving();
    }

    /**
     * Returns whether a motion or a drive is under way.
     *
     * @return true while the driver may have sent the robot a motion
     */
    public final boolean isBusy() {
        return gate.isBusy();
    }

    /**
     * Returns the permission to move that is in force.
     *
     * @return revoked by the next stop or the loss of the connection
     */
    public final Permit permit() {
        return gate.permit();
    }

    /** Refuses all motion until {@link #unlatch()}, and revokes as {@link #revokeMotions()} does. */
    public final void latch() {
        gate.latch(() -> new BotException("STOP is latched; \"release\" allows motion again"));
    }

    /** Allows motion again after {@link #latch()}. */
    public final void unlatch() {
        gate.unlatch();
    }

    /**
     * Takes note that a motion or drive begins that was commanded anew, before anything of it is sent: a turn of a
     * course, or the renewal of a drive, is none. Called as {@link #driveAt}. Does nothing unless overridden, for a
     * robot that others may take over: what was commanded before that must not take it back.
     */
    protected void motionBegins() {}

    /**
     * Drives straight until done. Every command that moves the robot is sent through the motion; exceptions it throws
     * must not be caught. Motors are switched on here when they are off, with a notice.
     *
     * @param mm finite, within {@code maxMove}, ahead positive
     * @param motion for sending and waiting
     * @return how far it went, mm
     */
    protected abstract Value moveBy(double mm, Motion motion);

    /**
     * Turns on the spot until done; otherwise as {@link #moveBy}.
     *
     * @param degrees finite, counterclockwise positive, perhaps several turns
     * @param motion for sending and waiting
     * @return how far it turned, degrees
     */
    protected abstract Value turnBy(double degrees, Motion motion);

    /**
     * Sends the command to drive a curve from now on, and does not wait for anything. Called repeatedly during a drive,
     * with no stop between; after the last call {@link #halt()} follows.
     *
     * @param mmPerSec within the profile's speeds, ahead positive
     * @param degPerSec within the profile's rates, counterclockwise positive
     */
    protected abstract void driveAt(double mmPerSec, double degPerSec);

    /**
     * Drives a curve for a time until done; otherwise as {@link #moveBy}. Calls {@link #driveAt} again and again, then
     * {@link #halt()} and {@link #confirmHalt()}, unless overridden for a robot that takes the time with the command.
     *
     * @param mmPerSec within the profile's speeds, ahead positive
     * @param degPerSec within the profile's rates, counterclockwise positive
     * @param seconds more than 0, at most 60
     * @param motion for sending and waiting
     * @return a description of how the speeds were adjusted; null if they were not
     */
    protected @Nullable Value driveFor(double mmPerSec, double degPerSec, double seconds, Motion motion) {
        return gate.driveRenewing(mmPerSec, degPerSec, seconds, motion);
    }

    /**
     * Returns how {@link #driveAt} adjusted the speeds requested last. Part of the answer to a drive for a given time.
     *
     * @return a description; null if the robot drives exactly as requested, or reports the difference in another way
     */
    protected @Nullable Value driven() {
        return null;
    }

    /**
     * Sends the stop command at once and does not wait for an answer. Called on any thread, with no other command being
     * sent meanwhile.
     */
    protected abstract void halt();

    /**
     * Sends the stop ahead of {@link #halt()}, over a connection that no command uses. For robots whose stop has a
     * connection of its own: {@code halt()} has to wait for the command that is being sent, up to the deadline of a
     * stuck link. Called for every stop once all permits are revoked, on the thread that stops, perhaps on several at a
     * time and while another thread is inside any other hook; must wait for none of them.
     *
     * <p>It replaces nothing. A command whose permit was checked before the stop may still go out behind this one;
     * {@code halt()} follows as soon as that has been sent, and has to stop that too. So the state that {@code halt()}
     * needs must not be cleared here. Does nothing unless overridden; what it throws is logged and {@code halt()}
     * follows all the same.
     */
    protected void haltAhead() {}

    /**
     * Waits until the robot has confirmed the stop that {@link #halt()} sent, sending it again where that helps. Called
     * without any lock, on the thread that stops and at the end of a drive for a time.
     *
     * @throws BotException if it is not confirmed within the driver's timeout
     */
    public void confirmHalt() {}

    /** Throws the {@link LinkLost} that ended the connection, if it was lost. */
    abstract void refuseLost();

    /** Throws a {@link BotException} unless the robot is connected. */
    abstract void requireConnected();

    /** Takes note that the connection was lost; only the first call after a connect counts. */
    abstract void lost(LinkLost cause);

    /** Sends a notice to the user. */
    abstract void notice(String message);

    /** Returns the table to which the parameters of the limits are added. */
    abstract ParameterTable table();

    final MotionLimits limits() {
        return limits;
    }

    final Readings readings() {
        return readings;
    }

    final RobotTimer timer() {
        return timer;
    }

    final MotionGate gate() {
        return gate;
    }
}
