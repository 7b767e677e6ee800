package majic.driver;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
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
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Reading;
import majic.bot.ScanListener;
import majic.bot.Uncertainty;
import majic.bot.Value;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;

/**
 * The driver of one robot. A subclass implements the protected abstract methods, which speak the robot's protocol. This
 * class checks arguments, lets one caller move the robot after the other, stops it, ends a {@code drive} that is not
 * renewed, calls listeners and defines the shared parameters.
 */
public abstract class BotDriver extends MovingRobot {
    /** The usual {@link #longestAgeS} of a robot that reports several times a second, seconds. */
    protected static final double LONGEST_AGE_S = 1.5;

    private volatile BotType type;
    private final Settings settings;
    private final ParameterTable parameters = new ParameterTable();
    private final CommandTable commands = new CommandTable();
    private final Readings readings = readings();
    private final ReadingRule rule = new ReadingRule(this, waiting(), this::longestAgeS);
    private final Listeners listeners;
    private final ConnectionLife life;
    private final ShutdownHook.Closing atShutdown;
    private final AtomicBoolean guardPending = new AtomicBoolean();

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
        super(profile, Objects.requireNonNull(environment, "environment").time());
        this.type = Objects.requireNonNull(type, "type");
        this.settings = environment.settings();
        this.listeners = new Listeners(this, time());
        this.life = new ConnectionLife(listeners::connectionChanged);
        this.name = "the " + type.label();
        this.atShutdown = new ShutdownHook.Closing(this::name, time(), this::revokeForGood, this::close);
        SharedParameters.describe(
                parameters,
                new SharedParameters.Source(this::state, this::uncertainty, this::profile, time()),
                this::setPose);
        limits().describe(parameters);
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
                listeners.start(time(), type.name());
                timer().start(type.name());
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
            DriverCode.run(this, this::open);
        } catch (ConnectFailed | LinkLost e) {
            throw e;
        } catch (BotException e) {
            throw new ConnectFailed(ConnectFailed.Reason.OTHER, String.valueOf(e.getMessage()), e);
        }
    }

    @Override
    public final Value get(String parameter) {
        return reading(parameter).value();
    }

    @Override
    public final Reading reading(String parameter) {
        return rule.read(entry(parameter));
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
            gate().perform(Guard.NEVER, permit, motion -> {
                writer.accept(fitted, motion);
                return null;
            });
        } else {
            requireConnected();
            DriverCode.run(this, () -> writer.accept(fitted, gate().beside(permit)));
        }
    }

    @Override
    public final String run(String command, List<Value> arguments, Guard until) {
        return run(command, arguments, until, permit());
    }

    final String run(String command, List<Value> arguments, Guard until, Permit permit) {
        DriverCommand known = commands.find(name, command);
        List<Value> fitted = Arguments.forCommand(known.command(), arguments);
        if (!known.command().moves()) {
            requireConnected();
            return DriverCode.call(this, () -> known.action().run(fitted, gate().beside(permit)));
        }
        MotionReport report = gate().perform(until, permit, motion -> {
            Value answer = Value.text(known.action().run(fitted, motion));
            if (motion.guardReached()) {
                gate().halt(motion);
            }
            return answer;
        });
        return String.valueOf(report.amount());
    }

    @Override
    public final List<Parameter> parameters() {
        return parameters.all();
    }

    @Override
    public final List<Parameter> unlistedParameters(String begun) {
        try {
            return parameters.begunWith(begun);
        } catch (BotException e) {
            return List.of();
        }
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
            timer().close();
            news();
            gate().end(before == Connection.CONNECTED);
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
    public final void place(Pose pose, Uncertainty uncertainty) {
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(uncertainty, "uncertainty");
        readings.place(pose, uncertainty);
        listeners.stateChanged();
    }

    @Override
    public final Optional<Pose> placedAt() {
        return readings.placedAt();
    }

    @Override
    public Uncertainty uncertainty() {
        return readings.uncertainty();
    }

    @Override
    public final Pose odometryOrigin() {
        return readings.odometryOrigin();
    }

    @Override
    public final void addListener(BotListener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    @Override
    public final void removeListener(BotListener listener) {
        listeners.remove(listener);
    }

    @Override
    public final void addScanListener(ScanListener listener) {
        listeners.addScanListener(Objects.requireNonNull(listener, "listener"));
        scansRequested(true);
    }

    @Override
    public final void removeScanListener(ScanListener listener) {
        listeners.removeScanListener(listener);
        scansRequested(hasScanListeners());
    }

    /**
     * Whether something asks for scans; a driver makes none otherwise.
     *
     * @return may change at any time
     */
    protected final boolean hasScanListeners() {
        return listeners.hasScanListeners();
    }

    /**
     * Begins or ends to request scans from the robot; does nothing unless overridden. A driver that requests scans does
     * so at the end of {@link #open()} too if {@link #hasScanListeners()}.
     *
     * @param requested whether something asks for them; may be called again with the same value, in any state of the
     *     connection; must not wait
     */
    protected void scansRequested(boolean requested) {}

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
     * Returns the table in which drivers describe the robot's own parameters.
     *
     * @return the table, with the shared ones in it
     */
    @Override
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
     * Returns the settings kept from one program start to the next.
     *
     * @return the settings
     */
    protected final Settings settings() {
        return settings;
    }

    /**
     * Publishes new readings and wakes the threads that wait for readings.
     *
     * @param newState what was read
     */
    protected final void publish(BotState newState) {
        readings.report(newState, profile().veerDegPerM());
        listeners.stateChanged();
        guardAgain();
    }

    /** Adapts a guarded drive to a new reading, behind the listeners that take the reading. */
    private void guardAgain() {
        if (gate().isGuarding() && guardPending.compareAndSet(false, true)) {
            listeners.afterwards(() -> {
                guardPending.set(false);
                gate().guardAgain();
            });
        }
    }

    /**
     * Returns how old a reading may be while the robot is connected, by the rule of {@link Reading}. A parameter whose
     * own time the table does not have ({@link ParameterTable.Entry#measured}) is as old as the newest state.
     *
     * @return seconds; without limit unless overridden, so that readings are current until the connection is lost
     */
    protected double longestAgeS() {
        return Double.POSITIVE_INFINITY;
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
    @Override
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
     * Publishes what a range sensor has measured. If several scans of a sensor come before the listeners take one, they
     * get the newest.
     *
     * @param scan its time is that of the robot's clock
     */
    protected final void publishScan(RangeScan scan) {
        listeners.scanned(scan);
        guardAgain();
    }

    /**
     * Reports that the connection was lost; all waiting threads wake with the cause. Only the first call after a
     * connect counts.
     *
     * @param cause how it was lost
     */
    @Override
    protected final void lost(LinkLost cause) {
        if (life.lose(cause, () -> gate().lost(cause))) {
            news();
            membership().ifPresent(there -> there.linkLost(String.valueOf(cause.getMessage())));
            listeners.deliver();
        }
    }

    @Override
    public final Optional<String> lostReason() {
        return Optional.ofNullable(life.lostBecause()).map(LinkLost::getMessage);
    }

    @Override
    final void requireConnected() {
        refuseLost();
        Connection now = life.now();
        if (now != Connection.CONNECTED) {
            throw new BotException(name + (now == Connection.CLOSED ? " is closed" : " is not connected"));
        }
    }

    @Override
    final void refuseLost() {
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
