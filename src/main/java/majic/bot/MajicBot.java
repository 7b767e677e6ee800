package majic.bot;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;
import javax.swing.JComponent;
import majic.text.Suggestion;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A robot under control. Can be used alone: make it, {@link #connect()}, command it, {@link #close()}.
 *
 * <p>Conventions, as in {@link BotControl}: mm, degrees counterclockwise positive, x ahead and y left of where it was
 * connected. Connecting neither moves the robot nor switches its motors on; the first motion does, and says so to the
 * listeners. All public methods are safe from any thread. Motions of several callers follow one another; {@link #stop()}
 * overtakes them.
 *
 * <p>Subclasses fill in the protected hooks. Checks of arguments, the order of callers, the stop, the end of a
 * {@code drive} that is not renewed, listeners and the shared parameters are done here, once.
 */
public abstract class MajicBot implements BotControl, Guard.ReadingSource, AutoCloseable {
    private final BotType type;
    private final BotEnvironment environment;
    private final ParameterTable parameters = new ParameterTable();
    private final List<BotCommand> commands = new CopyOnWriteArrayList<>();
    private final Listeners listeners;
    private final ConnectionLife life;
    private final List<Runnable> watchers = new CopyOnWriteArrayList<>();
    private final Signal changes;
    private final RobotTimer timer;
    private final MotionGate gate;
    private final AtomicLong readings = new AtomicLong();
    private final ShutdownHook.Closing atShutdown;

    private volatile BotProfile profile;
    private volatile Pace pace;
    private volatile String name;
    private volatile @Nullable TeamPlace place;
    private volatile BotState state = BotState.UNKNOWN;

    /** How a robot's connection stands. */
    public enum Connection {
        /** Not yet connected. */
        NEW,
        /** Being connected. */
        CONNECTING,
        /** Connected and answering. */
        CONNECTED,
        /** Broken, refused or given up; {@link MajicBot#connect()} may try again. */
        LOST,
        /** Closed for good. */
        CLOSED
    }

    /**
     * Makes a driver; touches no robot and starts no thread.
     *
     * @param type what it is a driver for
     * @param profile its size and pace
     * @param environment its clock and settings
     */
    protected MajicBot(BotType type, BotProfile profile, BotEnvironment environment) {
        this.type = type;
        this.profile = profile;
        this.pace = new Pace(profile);
        this.environment = environment;
        this.listeners = new Listeners(this, environment.time());
        this.life = new ConnectionLife(listeners::connectionChanged);
        this.changes = environment.time().signal();
        this.timer = new RobotTimer(environment.time());
        this.gate = new MotionGate(new Moving(), timer);
        this.name = "the " + type.label();
        this.atShutdown = new ShutdownHook.Closing(this::name, environment.time(), this::revokeForGood, this::close);
        SharedParameters.describe(
                parameters, new SharedParameters.Source(this::state, this::profile, environment.time()));
        pace.describe(parameters);
    }

    /**
     * Connects, without moving the robot or switching its motors on. May be called again after the connection was lost.
     *
     * <p>Until it is closed, a robot that was connected is also stopped and closed when the Java program ends by
     * {@code System.exit}, Ctrl-C or a signal; see {@link ShutdownHook}.
     *
     * @throws BotException if the robot is not there, refuses, or does not answer in the driver's time, or if the program
     *     is ending; the message says what to try, and the robot is in state {@link Connection#LOST}
     */
    public final void connect() {
        boolean first = life.begin(name);
        try {
            ShutdownHook.add(atShutdown);
            if (first) {
                listeners.start(time(), type.name());
                timer.start(type.name());
            }
            listeners.deliver();
            open();
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

    @Override
    public final MotionReport move(double mm, Guard until) {
        return move(mm, until, permit());
    }

    final MotionReport move(double mm, Guard until, Permit permit) {
        pace.checkMove(mm);
        return gate.perform(until, permit, motion -> moveBy(mm, motion));
    }

    @Override
    public final MotionReport turn(double degrees, Guard until) {
        return turn(degrees, until, permit());
    }

    final MotionReport turn(double degrees, Guard until, Permit permit) {
        Pace.checkTurn(degrees);
        return gate.perform(until, permit, motion -> turnBy(degrees, motion));
    }

    @Override
    public final MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until) {
        return drive(mmPerSec, degPerSec, seconds, until, permit());
    }

    final MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until, Permit permit) {
        Pace.checkDrive(profile, mmPerSec, degPerSec);
        Pace.checkDriveTime(seconds);
        return gate.drive(mmPerSec, degPerSec, seconds, until, permit);
    }

    @Override
    public final void drive(double mmPerSec, double degPerSec) {
        drive(mmPerSec, degPerSec, permit());
    }

    final void drive(double mmPerSec, double degPerSec, Permit permit) {
        Pace.checkDrive(profile, mmPerSec, degPerSec);
        gate.drive(mmPerSec, degPerSec, permit);
    }

    @Override
    public final void stop() {
        revokeMotions();
        if (isConnected()) {
            sendStop();
        }
    }

    /** Ends the leave of everybody who moves this robot now; quick, sends nothing. */
    public final void revokeMotions() {
        gate.permits().revokeAll(() -> new MotionStopped("stopped"));
        changes.raise();
    }

    /**
     * Tells the robot to stand and waits until it has confirmed it. Unlike {@link #stop()} it takes nobody's leave to
     * move the robot: for whoever revoked the leave that matters himself.
     *
     * @throws LinkLost if the connection was lost: nobody can tell it, so nobody may say it stands
     * @throws BotException if it is being connected again, or could not be; nobody can tell it then either
     */
    public final void sendStop() {
        if (writeStop()) {
            confirmHalt();
        }
    }

    /** The part of {@link #sendStop()} that writes; false for a robot that needs no stop, not connected yet or closed. */
    public final boolean writeStop() {
        changes.raise();
        refuseLost();
        Connection now = life.now();
        if (now == Connection.CONNECTING || now == Connection.LOST) {
            throw new BotException(name + " is not connected; nobody can tell it to stand");
        }
        boolean open = isConnected();
        if (open) {
            gate.writeStop();
        }
        return open;
    }

    @Override
    public final Value get(String parameter) {
        ParameterTable.Entry entry = entry(parameter);
        if (entry.reader() == null) {
            throw new ParameterException(parameter, entry.parameter().name() + ": can be set but not read");
        }
        return entry.reader().get();
    }

    @Override
    public final void set(String parameter, List<Value> values) {
        set(parameter, values, permit());
    }

    final void set(String parameter, List<Value> values, Permit permit) {
        ParameterTable.Entry entry = entry(parameter);
        BiFunction<List<Value>, Motion, @Nullable Value> writer = Arguments.writer(entry);
        List<Value> fitted = Arguments.forSet(entry.parameter(), values);
        if (entry.parameter().moves()) {
            gate.perform(Guard.NEVER, permit, motion -> writer.apply(fitted, motion));
        } else {
            requireConnected();
            writer.apply(fitted, gate.beside(permit));
        }
    }

    @Override
    public final String run(String command, List<Value> arguments) {
        return run(command, arguments, permit());
    }

    final String run(String command, List<Value> arguments, Permit permit) {
        BotCommand known = Arguments.command(name, commands(), command);
        List<Value> fitted = Arguments.forCommand(known, arguments);
        if (!known.moves()) {
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
        return List.copyOf(commands);
    }

    /**
     * Checks values for a parameter without setting it, as a script does before anything drives off.
     *
     * @param parameter its name
     * @param values as for {@link #set(String, List)}
     * @return the parameter
     * @throws ParameterException what setting it would throw for these values
     */
    public final Parameter checkSet(String parameter, List<Value> values) {
        ParameterTable.Entry entry = entry(parameter);
        Arguments.writer(entry);
        Arguments.forSet(entry.parameter(), values);
        return entry.parameter();
    }

    /**
     * Looks a parameter up.
     *
     * @param parameter its name, whatever the case
     * @return its description
     * @throws ParameterException if this robot has none of that name; the message suggests one
     */
    public final Parameter parameter(String parameter) {
        return entry(parameter).parameter();
    }

    /**
     * Stops the robot and closes the connection for good. Takes at most about a second, also when the link is stuck;
     * does nothing when it is closed already.
     */
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
            listeners.deliver();
            listeners.close();
        }
    }

    /** Ends all motions and allows no other; quick, sends nothing. */
    final void revokeForGood(String reason) {
        gate.permits().close(() -> new BotException(reason));
        changes.raise();
    }

    /**
     * Who answers there, as far as connecting told.
     *
     * @return article and make, {@code a MobileRobots Pioneer}; a driver whose robot tells more adds it
     */
    public String introduction() {
        return "a " + type.make();
    }

    /**
     * What draws this robot in the window.
     *
     * @return its panel, made on the event dispatch thread; null for "no display available"
     */
    public @Nullable JComponent display() {
        return null;
    }

    /**
     * Which make of robot this is.
     *
     * @return its type
     */
    public final BotType type() {
        return type;
    }

    @Override
    public final String name() {
        return name;
    }

    /**
     * The place in a team. Everything a display lets a person do with the robot goes through {@code Member.of(bot)}, so
     * that the owner of the robot and STOP are respected.
     *
     * @return empty for a robot that is used alone
     */
    public final Optional<TeamPlace> place() {
        return Optional.ofNullable(place);
    }

    /**
     * Takes the place in a team. Called by the team once, before the robot is told anything else.
     *
     * @param newPlace the place
     * @param newName how messages call the robot from then on
     */
    public final void join(TeamPlace newPlace, String newName) {
        place = newPlace;
        name = newName;
    }

    /**
     * Its size and pace.
     *
     * @return as known now; connecting may change it
     */
    public final BotProfile profile() {
        return profile;
    }

    /**
     * How its connection stands.
     *
     * @return the state now
     */
    public final Connection connection() {
        return life.now();
    }

    /**
     * Whether it can be commanded.
     *
     * @return true while connected
     */
    public final boolean isConnected() {
        return life.now() == Connection.CONNECTED;
    }

    /**
     * What it last said of itself.
     *
     * @return the newest state; {@link BotState#UNKNOWN} before the first word
     */
    public final BotState state() {
        return state;
    }

    /**
     * Begins to tell somebody of this robot. The first hears what it has said before anybody listened.
     *
     * @param listener called on the robot's listener thread, or on a thread that commands the robot
     */
    public final void addListener(BotListener listener) {
        listeners.add(listener);
    }

    /**
     * Ends telling somebody.
     *
     * @param listener who was added
     */
    public final void removeListener(BotListener listener) {
        listeners.remove(listener);
    }

    /**
     * Opens the link and goes through the protocol's handshake. Called once for each {@link #connect()}, on its thread,
     * in state {@link Connection#CONNECTING}. Must not move the robot nor switch motors on, must end within the
     * driver's time-out, and must leave nothing open when it throws.
     *
     * @throws BotException with what went wrong and what to try
     */
    protected abstract void open();

    /**
     * Halts the robot if it may move, says good-bye as the protocol has it, and closes the link, whatever state it is
     * in. Bounded by about a second; throws nothing.
     */
    protected abstract void shut();

    /**
     * Drives straight until done. Everything that moves is sent through the motion; when it throws, just let it pass.
     * Motors are switched on here when they are off, with a {@link #notice}.
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
     * Sends the command to drive a curve from now on, and does not wait for anything. Called again and again while
     * somebody drives, with no stop between; after the last call {@link #halt()} follows.
     *
     * @param mmPerSec within the profile's speeds, ahead positive
     * @param degPerSec within the profile's rates, counterclockwise positive
     */
    protected abstract void driveAt(double mmPerSec, double degPerSec);

    /**
     * What {@link #driveAt} made of what was wanted last. It stands in the answer to a drive that was given a time.
     *
     * @return in words; null where the robot drives just what is wanted, or says so otherwise
     */
    protected @Nullable Value driven() {
        return null;
    }

    /**
     * Sends the command to stand, at once, and does not wait for an answer. Called on any thread, with no other command
     * being sent meanwhile.
     */
    protected abstract void halt();

    /**
     * Sends the stop ahead of {@link #halt()}, over a line that no command ever uses. For robots whose stop has a
     * connection of its own: {@code halt()} has to wait for the command that is being sent, up to the deadline of a stuck
     * link. Called for every stop once all permits are revoked, on the thread that stops, perhaps on several at a time
     * and while another thread is inside any other hook; must wait for none of them.
     *
     * <p>It replaces nothing. A command whose permit was looked at before the stop may still go out behind this one;
     * {@code halt()} follows as soon as that has been sent, and has to stop that too. So what {@code halt()} needs to
     * know must not be forgotten here. Does nothing unless overridden; what it throws is logged and {@code halt()} follows
     * all the same.
     */
    protected void haltAhead() {}

    /**
     * Waits until the robot has confirmed the stop that {@link #halt()} sent, sending it again where that helps. Called
     * without any lock, on the thread that stops and at the end of a drive for a time.
     *
     * @throws BotException if it is not confirmed in the driver's time
     */
    public void confirmHalt() {}

    /**
     * Where to describe the robot's own parameters.
     *
     * @return the table, with the shared ones in it
     */
    protected final ParameterTable table() {
        return parameters;
    }

    /**
     * Adds a command that only this type has, in place of one of the same name.
     *
     * @param command its description and what it does
     */
    protected final void add(BotCommand command) {
        removeCommand(command.name());
        commands.add(command);
    }

    /**
     * Takes a command away again, such as one for equipment that the robot turns out not to have.
     *
     * @param command its name; nothing happens if there is none
     */
    protected final void removeCommand(String command) {
        commands.removeIf(known -> known.name().equalsIgnoreCase(command));
    }

    /**
     * Takes over a size and pace learned from the robot itself.
     *
     * @param better the new profile; cruise and near start from it, where nobody has set them
     */
    protected final void profile(BotProfile better) {
        profile = better;
        pace = pace.fittedTo(better);
        pace.describe(parameters);
    }

    /**
     * How fast {@code move} is to go.
     *
     * @return mm/s, positive
     */
    protected final double cruiseMmPerSec() {
        return pace.cruiseMmPerSec();
    }

    /**
     * How fast {@code turn} is to go.
     *
     * @return deg/s, positive
     */
    protected final double cruiseTurnDegPerSec() {
        return pace.cruiseTurnDegPerSec();
    }

    /**
     * The clock of this robot.
     *
     * @return the only way its driver may wait and measure
     */
    public final TimeSource time() {
        return environment.time();
    }

    /**
     * What the user wants remembered.
     *
     * @return the settings
     */
    protected final Settings settings() {
        return environment.settings();
    }

    /**
     * Where everybody waits who waits for this robot. Drivers raise it after anything that somebody may wait for.
     *
     * @return the signal
     */
    protected final Signal changes() {
        return changes;
    }

    /**
     * Does something again and again, on the robot's own timer thread, from now until it is closed.
     *
     * @param what names the duty; one of the same name is replaced
     * @param seconds the period
     * @param task quick; failures are logged
     */
    public final void every(String what, double seconds, Runnable task) {
        timer.every(what, seconds, task);
    }

    /**
     * Publishes new readings and wakes whoever waits for some.
     *
     * @param newState what was read
     */
    protected final void publish(BotState newState) {
        state = newState;
        news();
        listeners.stateChanged();
    }

    /**
     * Tells that a parameter may read differently though the state is the same; guards of this robot's motions look again.
     */
    protected final void news() {
        lookAgain();
        watchers.forEach(Runnable::run);
    }

    private void lookAgain() {
        readings.incrementAndGet();
        changes.raise();
    }

    /**
     * Says something to the person.
     *
     * @param message one sentence or half of one
     */
    public final void notice(String message) {
        listeners.notice(message);
    }

    /**
     * Tells that the link broke; everybody who waits wakes with the cause. Only the first call after a connect counts.
     *
     * @param cause how it was lost
     */
    protected final void lost(LinkLost cause) {
        if (life.lose(cause, () -> gate.lost(cause))) {
            news();
            place().ifPresent(there -> there.linkLost(String.valueOf(cause.getMessage())));
            listeners.deliver();
        }
    }

    /**
     * Whether somebody drives this robot with {@link #drive(double, double)} just now.
     *
     * @return true from a drive until its lease ends
     */
    protected final boolean isDriving() {
        return gate.isDriving();
    }

    /**
     * Whether a motion or a drive is under way.
     *
     * @return true while the driver may have told the robot to move
     */
    public final boolean isBusy() {
        return gate.isBusy();
    }

    /**
     * The permission to move that is in force.
     *
     * @return revoked by the next stop or the loss of the connection
     */
    public final Permit permit() {
        return gate.permits().current();
    }

    /** Refuses all motion until {@link #unlatch()}. */
    public final void latch() {
        gate.permits().latch(() -> new BotException("STOP is latched; \"release\" allows motion again"));
        changes.raise();
    }

    /** Allows motion again after {@link #latch()}. */
    public final void unlatch() {
        gate.permits().unlatch();
    }

    /**
     * How the connection was lost.
     *
     * @return one sentence; empty while there is a connection, and after an attempt to connect that failed
     */
    public final Optional<String> lostReason() {
        return Optional.ofNullable(life.lostBecause()).map(LinkLost::getMessage);
    }

    private void requireConnected() {
        refuseLost();
        if (!isConnected()) {
            throw new BotException(name + " is not connected");
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
        watchers.add(watcher);
    }

    @Override
    public final void removeWatcher(Runnable watcher) {
        watchers.remove(watcher);
    }

    private ParameterTable.Entry entry(String parameter) {
        ParameterTable.Entry entry = parameters.find(parameter);
        if (entry == null) {
            List<String> names = parameters().stream().map(Parameter::name).toList();
            throw new ParameterException(
                    parameter,
                    parameter + ": " + name + " has no such parameter" + Suggestion.didYouMean(parameter, names));
        }
        return entry;
    }

    /** This robot as its motions use it. */
    private final class Moving implements MovingRobot {
        @Override
        public String name() {
            return name;
        }

        @Override
        public TimeSource time() {
            return environment.time();
        }

        @Override
        public Signal changes() {
            return changes;
        }

        @Override
        public boolean isConnected() {
            return MajicBot.this.isConnected();
        }

        @Override
        public void requireConnected() {
            MajicBot.this.requireConnected();
        }

        @Override
        public long readings() {
            return readings.get();
        }

        @Override
        public void lookAgain() {
            MajicBot.this.lookAgain();
        }

        @Override
        public void notice(String message) {
            MajicBot.this.notice(message);
        }

        @Override
        public void lost(LinkLost cause) {
            MajicBot.this.lost(cause);
        }

        @Override
        public void driveAt(double mmPerSec, double degPerSec) {
            MajicBot.this.driveAt(mmPerSec, degPerSec);
        }

        @Override
        public void halt() {
            MajicBot.this.halt();
        }

        @Override
        public void haltAhead() {
            MajicBot.this.haltAhead();
        }

        @Override
        public void confirmHalt() {
            MajicBot.this.confirmHalt();
        }

        @Override
        public @Nullable Value driven() {
            return MajicBot.this.driven();
        }
    }
}
