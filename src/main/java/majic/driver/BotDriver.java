package majic.driver;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.ConnectFailed;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The driver of one robot. A subclass implements the protected hooks, which speak the robot's protocol. This class
 * checks arguments, orders callers, stops, ends a {@code drive} that is not renewed, calls listeners and defines the
 * shared parameters.
 */
public abstract class BotDriver extends MajicBot {
    private volatile BotType type;
    private final TimeSource time;
    private final Settings settings;
    private final ParameterTable parameters = new ParameterTable();
    private final CommandTable commands = new CommandTable();
    private final Listeners listeners;
    private final ConnectionLife life;
    private final Signal changes;
    private final Readings readings;
    private final RobotTimer timer;
    private final MotionGate gate;
    private final ShutdownHook.Closing atShutdown;

    private volatile BotProfile profile;
    private volatile MotionLimits limits;
    private volatile String name;
    private volatile @Nullable TeamMembership membership;

    /**
     * Creates a driver; contacts no robot and starts no thread.
     *
     * @param type what it is a driver for
     * @param profile its size and pace
     * @param environment its clock and settings
     */
    protected BotDriver(BotType type, BotProfile profile, BotEnvironment environment) {
        this.type = Objects.requireNonNull(type, "type");
        this.profile = Objects.requireNonNull(profile, "profile");
        this.limits = new MotionLimits(profile);
        this.time = Objects.requireNonNull(environment, "environment").time();
        this.settings = environment.settings();
        this.listeners = new Listeners(this, time);
        this.life = new ConnectionLife(listeners::connectionChanged);
        this.changes = time.signal();
        this.readings = new Readings(changes);
        this.timer = new RobotTimer(time);
        this.gate = new MotionGate(new MovingDriver(this, readings), timer);
        this.name = "the " + type.label();
        this.atShutdown = new ShutdownHook.Closing(this::name, time, this::revokeForGood, this::close);
        SharedParameters.describe(
                parameters, new SharedParameters.Source(this::state, this::profile, time), this::setPose);
        limits.describe(parameters);
    }

    /**
     * Returns a robot as teams and acts command it: with permits, a stop in two steps, and its membership.
     *
     * @param bot a robot
     * @return the same object
     * @throws BotException if its class does not extend this one
     */
    public static BotDriver of(MajicBot bot) {
        if (Objects.requireNonNull(bot, "bot") instanceof BotDriver driver) {
            return driver;
        }
        throw new BotException(bot.name() + " cannot be commanded by a team or an act: its class "
                + bot.getClass().getName() + " does not extend " + BotDriver.class.getName());
    }

    @Override
    public final void connect() {
        boolean first = life.begin(name);
        try {
            ShutdownHook.add(atShutdown);
            if (first) {
                listeners.start(time, type.name());
                timer.start(type.name());
            }
            readings.reconnecting();
            listeners.deliver();
            openOrExplain();
        } catch (RuntimeException | Error e) {
            life.end(Connection.LOST);
            listeners.deliver();
            throw e;
        }
        if (!life.end(Connection.CONNECTED)) {
            shut();
        }
        news();
        listeners.deliver();
        requireConnected();
    }

    private void openOrExplain() {
        try {
            open();
        } catch (ConnectFailed | LinkLost e) {
            throw e;
        } catch (BotException e) {
            throw new ConnectFailed(ConnectFailed.Reason.OTHER, String.valueOf(e.getMessage()), e);
        }
    }

    @Override
    public final MotionReport move(double mm, Guard until) {
        return move(mm, until, permit());
    }

    final MotionReport move(double mm, Guard until, Permit permit) {
        limits.checkMove(mm);
        return gate.perform(until, permit, motion -> moveBy(mm, motion));
    }

    @Override
    public final MotionReport turn(double degrees, Guard until) {
        return turn(degrees, until, permit());
    }

    final MotionReport turn(double degrees, Guard until, Permit permit) {
        limits.checkTurn(degrees);
        return gate.perform(until, permit, motion -> turnBy(degrees, motion));
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
    public final void drive(double mmPerSec, double degPerSec) {
        drive(mmPerSec, degPerSec, permit());
    }

    final void drive(double mmPerSec, double degPerSec, Permit permit) {
        limits.checkDrive(mmPerSec, degPerSec);
        gate.drive(mmPerSec, degPerSec, permit);
    }

    @Override
    public final void stop() {
        revokeMotions();
        if (isConnected()) {
            sendStop();
        } else {
            changes.raise();
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
            Connection now = life.now();
            if (now == Connection.CONNECTING || now == Connection.LOST) {
                throw new BotException(name + " is not connected, so no stop can reach it");
            }
            boolean open = isConnected();
            if (open) {
                gate.writeStop();
            }
            return open;
        } finally {
            changes.raise();
        }
    }

    @Override
    public final Value get(String parameter) {
        return entry(parameter).reader().get();
    }

    @Override
    public final void set(String parameter, List<Value> values) {
        set(parameter, values, permit());
    }

    final void set(String parameter, List<Value> values, Permit permit) {
        ParameterTable.Entry entry = entry(parameter);
        BiConsumer<List<Value>, Motion> writer = entry.writer();
        List<Value> fitted = Arguments.forSet(entry.parameter(), values);
        if (entry.parameter().moves()) {
            gate.perform(Guard.NEVER, permit, motion -> {
                writer.accept(fitted, motion);
                return null;
            });
        } else {
            requireConnected();
            writer.accept(fitted, gate.beside(permit));
        }
    }

    @Override
    public final String run(String command, List<Value> arguments) {
        return run(command, arguments, permit());
    }

    final String run(String command, List<Value> arguments, Permit permit) {
        DriverCommand known = commands.find(name, command);
        List<Value> fitted = Arguments.forCommand(known.command(), arguments);
        if (!known.command().moves()) {
            requireConnected();
            return known.action().run(fitted, gate.beside(permit));
        }
        MotionReport report = gate.perform(
                Guard.NEVER, permit, motion -> Value.text(known.action().run(fitted, motion)));
        return String.valueOf(report.amount());
    }

    @Override
    public final List<Parameter> parameters() {
        return parameters.all();
    }

    @Override
    public final List<BotCommand> commands() {
        return commands.all();
    }

    @Override
    public final Parameter checkSet(String parameter, List<Value> values) {
        ParameterTable.Entry entry = entry(parameter);
        entry.writer();
        Arguments.forSet(entry.parameter(), values);
        return entry.parameter();
    }

    @Override
    public final void checkRun(String command, List<Value> arguments) {
        Arguments.forCommand(commands.find(name, command).command(), arguments);
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

    @Override
    public final Parameter parameter(String parameter) {
        return entry(parameter).parameter();
    }

    @Override
    public final void close() {
        Connection before = life.close(() -> revokeForGood(name + " is closed"));
        if (before == Connection.CLOSED) {
            return;
        }
        try {
            timer.close();
            news();
            gate.end(before == Connection.CONNECTED);
            if (before != Connection.NEW) {
                shut();
            }
        } finally {
            ShutdownHook.remove(atShutdown);
            try {
                listeners.deliver();
            } finally {
                listeners.close();
            }
        }
    }

    /** Ends all motions and permits no others; does not block, sends nothing. */
    final void revokeForGood(String reason) {
        gate.close(() -> new BotException(reason));
        changes.raise();
    }

    @Override
    public final BotType type() {
        return type;
    }

    @Override
    public final String name() {
        return name;
    }

    /**
     * Returns the membership in a team.
     *
     * @return empty for a robot that is used alone
     */
    public final Optional<TeamMembership> membership() {
        return Optional.ofNullable(membership);
    }

    /**
     * Records the membership in a team. Called by the team once, before any other command.
     *
     * @param newMembership the membership
     * @param newName the robot's name in messages from then on
     */
    public final void join(TeamMembership newMembership, String newName) {
        membership = newMembership;
        name = newName;
    }

    @Override
    public final BotProfile profile() {
        return profile;
    }

    @Override
    public final Connection connection() {
        return life.now();
    }

    @Override
    public final boolean isConnected() {
        return life.now() == Connection.CONNECTED;
    }

    @Override
    public final BotState state() {
        return readings.state();
    }

    @Override
    public final void place(Pose pose) {
        Objects.requireNonNull(pose, "pose");
        readings.place(pose);
        listeners.stateChanged();
    }

    @Override
    public final Optional<Pose> placedAt() {
        return readings.placedAt();
    }

    @Override
    public final void addListener(BotListener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    @Override
    public final void removeListener(BotListener listener) {
        listeners.remove(listener);
    }

    /**
     * Opens the connection and performs the protocol's handshake. Called once for each {@link #connect()}, on its
     * thread, in state {@link Connection#CONNECTING}. Must not move the robot nor switch motors on, must end within the
     * driver's timeout, and must close everything it opened when it throws.
     *
     * @throws ConnectFailed with the reason, what went wrong and what to try; another {@link BotException} becomes a
     *     {@code ConnectFailed} for another reason
     */
    protected abstract void open();

    /**
     * Stops the robot if it may be moving, ends the session as the protocol requires, and closes the connection, in any
     * state. Takes at most about a second; throws nothing.
     */
    protected abstract void shut();

    /**
     * Drives straight until done. Every command that moves the robot is sent through the motion; exceptions it throws
     * must not be caught. Motors are switched on here when they are off, with a {@link #notice}.
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
     * Sends the command to drive a curve from now on, and does not wait for anything. Called repeatedly during a
     * drive, with no stop between; after the last call {@link #halt()} follows.
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
     * Sends the stop command at once and does not wait for an answer. Called on any thread, with no other command
     * being sent meanwhile.
     */
    protected abstract void halt();

    /**
     * Sends the stop ahead of {@link #halt()}, over a connection that no command uses. For robots whose stop has a
     * connection of its own: {@code halt()} has to wait for the command that is being sent, up to the deadline of a
     * stuck link. Called for every stop once all permits are revoked, on the thread that stops, perhaps on several at a
     * time and while another thread is inside any other hook; must wait for none of them.
     *
     * <p>It replaces nothing. A command whose permit was checked before the stop may still go out behind this one;
     * {@code halt()} follows as soon as that has been sent, and has to stop that too. So the state that
     * {@code halt()} needs must not be cleared here. Does nothing unless overridden; what it throws is logged and
     * {@code halt()} follows all the same.
     */
    protected void haltAhead() {}

    /**
     * Waits until the robot has confirmed the stop that {@link #halt()} sent, sending it again where that helps. Called
     * without any lock, on the thread that stops and at the end of a drive for a time.
     *
     * @throws BotException if it is not confirmed within the driver's timeout
     */
    public void confirmHalt() {}

    /**
     * Returns the table in which drivers describe the robot's own parameters.
     *
     * @return the table, with the shared ones in it
     */
    protected final ParameterTable table() {
        return parameters;
    }

    /**
     * Adds a command that only this type has; replaces one of the same name.
     *
     * @param command its description and what it does
     */
    protected final void add(DriverCommand command) {
        commands.add(command);
    }

    /**
     * Removes a command, such as one for equipment that the robot turns out not to have.
     *
     * @param command its name; nothing happens if there is none
     */
    protected final void removeCommand(String command) {
        commands.remove(command);
    }

    /**
     * Replaces the size and pace by those read from the robot itself.
     *
     * @param better the new profile; default for cruise and near unless they have been set
     */
    protected final void profile(BotProfile better) {
        profile = better;
        limits = limits.fittedTo(better);
        limits.describe(parameters);
    }

    /**
     * Replaces the type by the one that the robot turned out to have. To be called while connecting for the first time.
     *
     * @param found the type that users, roles of acts and scripts see from now on
     */
    protected final void type(BotType found) {
        type = Objects.requireNonNull(found, "found");
    }

    /**
     * Sets the parameter {@code pose}: places the robot, unless overridden for one whose pose others see as well.
     *
     * @param pose finite
     */
    protected void setPose(Pose pose) {
        place(pose);
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
        return time;
    }

    /**
     * Returns the settings kept from one program start to the next.
     *
     * @return the settings
     */
    protected final Settings settings() {
        return settings;
    }

    /**
     * Returns the signal that all threads waiting for this robot wait on. Drivers raise it after any change a thread may wait
     * for.
     *
     * @return the signal
     */
    protected final Signal changes() {
        return changes;
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
     * Publishes new readings and wakes the threads that wait for readings.
     *
     * @param newState what was read
     */
    protected final void publish(BotState newState) {
        readings.report(newState);
        listeners.stateChanged();
    }

    /**
     * Reports that a parameter may have changed though the state is the same; guards of this robot's motions are
     * rechecked.
     */
    protected final void news() {
        readings.news();
    }

    /**
     * Sends a notice to the user.
     *
     * @param message one sentence or half of one
     */
    public final void notice(String message) {
        listeners.notice(message);
    }

    /**
     * Publishes a picture of the camera.
     *
     * @param jpeg makes a JPEG file of it; called only if a listener wants it, on any thread
     */
    protected final void publishPicture(Supplier<byte[]> jpeg) {
        listeners.pictureTaken(jpeg);
    }

    /**
     * Reports that the connection was lost; all waiting threads wake with the cause. Only the first call after a
     * connect counts.
     *
     * @param cause how it was lost
     */
    protected final void lost(LinkLost cause) {
        if (life.lose(cause, () -> gate.lost(cause))) {
            news();
            membership().ifPresent(there -> there.linkLost(String.valueOf(cause.getMessage())));
            listeners.deliver();
        }
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

    @Override
    public final Optional<String> lostReason() {
        return Optional.ofNullable(life.lostBecause()).map(LinkLost::getMessage);
    }

    final void requireConnected() {
        refuseLost();
        if (!isConnected()) {
            throw new BotException(name + (life.now() == Connection.CLOSED ? " is closed" : " is not connected"));
        }
    }

    private void refuseLost() {
        LinkLost cause = life.lostBecause();
        if (cause != null) {
            throw new LinkLost(cause.getMessage(), cause);
        }
    }

    @Override
    public final void addWatcher(Runnable watcher) {
        readings.addWatcher(Objects.requireNonNull(watcher, "watcher"));
    }

    @Override
    public final void removeWatcher(Runnable watcher) {
        readings.removeWatcher(watcher);
    }

    private ParameterTable.Entry entry(String parameter) {
        return parameters.find(name, Objects.requireNonNull(parameter, "parameter"));
    }
}
