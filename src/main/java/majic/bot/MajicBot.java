package majic.bot;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.JComponent;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A robot under control. Can be used alone: make it, {@link #connect()}, command it, {@link #close()}.
 *
 * <p>Conventions, as in {@link BotControl}: mm, degrees counterclockwise positive, x ahead and y left of where it was
 * connected. Connecting neither moves the robot nor switches its motors on; the first motion does, and sends a notice
 * to the listeners. All public methods are thread-safe. Motions of several callers run one after the other;
 * {@link #stop()} overtakes them.
 *
 * <p>The drivers of robots extend {@link majic.driver.BotDriver}, which implements all of this.
 */
public abstract class MajicBot implements BotControl, Guard.ReadingSource, AutoCloseable {
    private static final String ALTITUDE = "altitude";

    /** The state of a robot's connection. */
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
     * Connects, without moving the robot or switching its motors on. May be called again after the connection was lost.
     *
     * <p>Until it is closed, a robot that was connected is also stopped and closed when the Java program ends by
     * {@code System.exit}, Ctrl-C or a signal.
     *
     * <p>It returns when the robot has sent its first readings, so that {@link #get} of them can be used at once, and
     * when the listeners have received the change of the connection, as {@link BotListener} describes.
     *
     * @throws ConnectFailed if the robot is not found, refuses, or does not answer within the driver's timeout; the
     *     message contains what to try, {@link ConnectFailed#reason()} tells the cases apart, and the robot is in state
     *     {@link Connection#LOST}
     * @throws LinkLost if the connection broke before it was ready; the robot is in state {@link Connection#LOST}
     * @throws BotException if it is connected, being connected or closed already, or if the program is ending
     */
    public abstract void connect();

    /**
     * Checks values for a parameter without setting it, as a script does before any robot moves.
     *
     * @param parameter its name
     * @param values as for {@link #set(String, List)}
     * @return the parameter
     * @throws ParameterException what setting it would throw for these values
     */
    public abstract Parameter checkSet(String parameter, List<Value> values);

    /**
     * Checks arguments for one of the commands that only this type of robot has, without running it.
     *
     * @param command its name, whatever the case
     * @param arguments as for {@link #run(String, List)}
     * @throws BotException what running it would throw for these arguments
     */
    public abstract void checkRun(String command, List<Value> arguments);

    /**
     * Checks the distance of a {@code move} against the present {@code maxMove}.
     *
     * @param mm the distance, mm, ahead positive
     * @throws ParameterException if it is longer, or not finite
     */
    public abstract void checkMove(double mm);

    /**
     * Checks the angle of a {@code turn}.
     *
     * @param degrees the angle, counterclockwise positive; at most 36000 either way
     * @throws ParameterException if it is larger, or not finite
     */
    public abstract void checkTurn(double degrees);

    /**
     * Checks a {@code drive} for a time against what the robot can do.
     *
     * @param mmPerSec the speed, mm/s, ahead positive
     * @param degPerSec the turn rate, deg/s, counterclockwise positive
     * @param seconds for how long; more than 0, at most 60
     * @throws ParameterException if it is too fast or too long
     */
    public abstract void checkDrive(double mmPerSec, double degPerSec, double seconds);

    /**
     * Looks a parameter up.
     *
     * @param parameter its name, whatever the case
     * @return its description
     * @throws ParameterException if this robot has none of that name; the message suggests one
     */
    public abstract Parameter parameter(String parameter);

    /**
     * Stops the robot and closes the connection for good. Takes at most about a second, also when the link is stuck;
     * does nothing when it is closed already. Returns when the listeners have received the change, as
     * {@link BotListener} describes.
     */
    @Override
    public abstract void close();

    /**
     * Returns what kind of robot it is, for lists: the label of its type, or more where connecting has found it out.
     *
     * @return with a capital letter: {@code Pioneer}; of a MAVLink vehicle that was connected {@code Copter}
     */
    public String kind() {
        return type().label();
    }

    /**
     * Describes the connected robot, as far as connecting reported it.
     *
     * @return article and make, {@code a MobileRobots Pioneer}; a driver whose robot reports more adds it
     */
    public String introduction() {
        return "a " + type().make();
    }

    /**
     * Returns what distinguishes the robot from all others, where connecting found it out. Two connections with one
     * robot have the same identity, whatever their addresses are.
     *
     * @return as found by the newest connection; empty before, and for robots that are distinguished by their addresses
     *     alone
     */
    public Optional<String> identity() {
        return Optional.empty();
    }

    /**
     * Returns the component that displays this robot in the window.
     *
     * @return its panel, made on the event dispatch thread; null for "no display available"
     */
    public @Nullable JComponent display() {
        return null;
    }

    /**
     * Returns what the display shows beyond the parameters, in a form that can be recorded; {@link BotType#replay}
     * makes a display of it again. Called up to 20 times a second on a thread that must neither wait nor cause a
     * request.
     *
     * @return texts by the driver's own names; empty if a replay shows only the parameters
     */
    public Map<String, String> displayState() {
        return Map.of();
    }

    /**
     * Returns whether this robot has a camera of which pictures can be taken.
     *
     * @return as known now; connecting may change it
     */
    public boolean hasCamera() {
        return false;
    }

    /**
     * Takes a picture with the robot's camera. Blocks for about 5 s at most; the robot may move meanwhile.
     *
     * @return a JPEG file
     * @throws BotException if there is no camera, or no picture comes in time
     */
    public byte[] takePicture() {
        throw new BotException(name() + " has no camera");
    }

    /**
     * Returns the type of this robot.
     *
     * @return its type
     */
    public abstract BotType type();

    /**
     * Returns the size and the speeds of this robot.
     *
     * @return as known now; connecting may change it
     */
    public abstract BotProfile profile();

    /**
     * Returns the state of its connection.
     *
     * @return the state now
     */
    public abstract Connection connection();

    /**
     * Returns whether it can be commanded.
     *
     * @return true while connected
     */
    public abstract boolean isConnected();

    /**
     * Returns the user of another program that alone may move this robot at present.
     *
     * @return the user, such as {@code Anna at desk1}; empty if no other program holds the robot, as far as it is known
     */
    public Optional<String> remoteHolder() {
        return Optional.empty();
    }

    /**
     * Returns the last state the robot reported.
     *
     * @return the newest state; {@link BotState#UNKNOWN} before the first report
     */
    public abstract BotState state();

    /**
     * Sets the pose that this robot reports at its present place. Moves nothing and sends nothing; a motion in progress
     * continues. The poses that follow are relative to it, also after the connection was lost and restored.
     *
     * @param pose where the robot is, in a frame that several robots can share: that of the team map
     * @param uncertainty of that pose; from here on it grows with the way and the turns by odometry.
     *     {@link Uncertainty#UNKNOWN} if the robot is lost: the pose is a guess
     */
    public abstract void place(Pose pose, Uncertainty uncertainty);

    /**
     * Sets the pose as {@link #place(Pose, Uncertainty)} does, as precisely as a person places a robot.
     *
     * @param pose where the robot is
     */
    public final void place(Pose pose) {
        place(pose, Uncertainty.BY_HAND);
    }

    /**
     * Returns where this robot was placed last.
     *
     * @return the pose passed to {@link #place}; empty if its poses are relative to where it was connected
     */
    public abstract Optional<Pose> placedAt();

    /**
     * Returns how far the true pose of the robot may be from the one it reports.
     *
     * @return {@link Uncertainty#UNKNOWN} until it is placed, and while it is lost
     */
    public abstract Uncertainty uncertainty();

    /**
     * Returns how high the robot is now: its parameter {@code altitude} in mm, if its profile says that it leaves the
     * ground; waits for nothing.
     *
     * @return mm above where it took off; empty for a robot that stays on the ground, and if the height is not known
     *     now
     */
    public OptionalDouble heightMm() {
        if (!profile().leavesGround() || parameters().stream().noneMatch(MajicBot::isAltitude)) {
            return OptionalDouble.empty();
        }
        return get(ALTITUDE) instanceof Value.Number height && Double.isFinite(height.amount())
                ? OptionalDouble.of(height.amount())
                : OptionalDouble.empty();
    }

    private static boolean isAltitude(Parameter parameter) {
        return parameter.name().equals(ALTITUDE) && parameter.unit() == Unit.MM;
    }

    /**
     * Returns the circle that the robot must not leave; waits for nothing.
     *
     * @return empty for a robot without a fence, and while the middle of the fence is not known
     */
    public Optional<Fence> fence() {
        return Optional.empty();
    }

    /**
     * Returns the parameters that describe this one robot and hold for longer than a session, such as measured speeds.
     * They are saved with a team.
     *
     * @return names of parameters that can be read and set while the robot is stationary; none unless overridden
     */
    public List<String> calibration() {
        return List.of();
    }

    /**
     * Returns where the odometry of the robot has its origin, in the frame of its poses:
     * {@code odometryOrigin().plus(scan.odometry())} is the pose at which a scan was measured. {@link #place} changes
     * it.
     *
     * @return the start of the robot until it is placed
     */
    public abstract Pose odometryOrigin();

    /**
     * Returns the sensors with which the robot measures distances along beams, such as sonars or a laser scanner.
     *
     * @return known once the robot is connected; a sensor that the robot describes only with its readings may come or
     *     become another one later, as the driver says; none unless overridden
     */
    public List<RangeSensor> rangeSensors() {
        return List.of();
    }

    /**
     * Asks for what the range sensors measure. While nothing asks, a robot neither computes scans nor requests them.
     * Power that a sensor needs, such as that of sonars, is not switched on by it.
     *
     * @param listener called on the robot's listener thread, from now on
     */
    public abstract void addScanListener(ScanListener listener);

    /**
     * Asks no longer.
     *
     * @param listener one that was added; it may be called once more
     */
    public abstract void removeScanListener(ScanListener listener);

    /**
     * Returns how this robot is looked for on the map of another program, which alone keeps its place right: this
     * program must not correct it, since the frames of their maps may differ.
     *
     * @return empty if this program keeps its place; otherwise has the other program look for it everywhere on its map,
     *     blocks until that has answered, and throws a {@link BotException} if it refuses
     */
    public Optional<Runnable> remoteLocalization() {
        return Optional.empty();
    }

    /**
     * Sets what finds obstacles for guarded driving: for motions while the parameter {@code guard} is on, and for
     * drives by hand.
     *
     * @param guard for this robot; null for none
     */
    public abstract void useGuard(@Nullable DriveGuard guard);

    /**
     * Returns whether guarded driving has anything to go by.
     *
     * @return false for a robot without sensors for it, as long as no map shows what is around it
     */
    public abstract boolean canBeGuarded();

    /**
     * Returns why a guarded {@link #drive(double, double)} that is in progress is slower than requested, or stands.
     *
     * @return half a sentence; empty while nothing holds it back
     */
    public abstract Optional<String> heldBack();

    /**
     * Adds a listener. The first one also receives the notices from before there was a listener.
     *
     * @param listener called on the robot's listener thread, or on a thread that commands the robot
     */
    public abstract void addListener(BotListener listener);

    /**
     * Removes a listener.
     *
     * @param listener the listener that was added
     */
    public abstract void removeListener(BotListener listener);

    /**
     * Returns the clock of this robot.
     *
     * @return the clock by which its driver waits and measures
     */
    public abstract TimeSource time();

    /**
     * Returns the error that ended the connection.
     *
     * @return one sentence; empty while there is a connection, and after an attempt to connect that failed
     */
    public abstract Optional<String> lostReason();

    /**
     * Returns parameters that are too many for {@link #parameters()}, such as those of an autopilot. They can be read
     * and set by their names. The first call may have the robot asked for them in the background; waits for nothing.
     *
     * @param begun how their names begin, in any case
     * @return those that are known so far
     */
    public List<Parameter> unlistedParameters(String begun) {
        return List.of();
    }
}
