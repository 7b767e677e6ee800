package majic.bot;

import java.util.List;
import java.util.Objects;

/**
 * The operations of a robot. Distances are millimetres, ahead positive; angles degrees, counterclockwise positive.
 * Thread-safe; all methods but {@link #drive} and {@link #stop} may wait for the robot, none of them without end.
 *
 * <p>What is thrown is always a {@link BotException}: {@link MotionStopped} when a stop came between, {@link LinkLost}
 * when the connection is gone, {@link MotionFailed} when the robot gave up, {@link ParameterException} when a name or
 * value is wrong and nothing was sent.
 */
public interface BotControl {
    /** How long a drive without a given time holds unless it is renewed, seconds. */
    double DRIVE_LEASE_S = 0.6;

    /**
     * Returns the name of the robot in messages.
     *
     * @return for instance {@code robot 1 (Aibo)}; before it is in a team, {@code the Aibo}
     */
    String name();

    /**
     * Drives straight and returns when the robot is stationary again.
     *
     * @param mm how far, ahead positive; at most the parameter {@code maxMove} either way
     * @param until ends the motion early
     * @return how far it went
     */
    MotionReport move(double mm, Guard until);

    /**
     * Turns on the spot and returns when the robot is stationary again.
     *
     * @param degrees how far, counterclockwise positive; more than a full turn goes all the way round
     * @param until ends the motion early
     * @return how far it turned
     */
    MotionReport turn(double degrees, Guard until);

    /**
     * Drives a curve for a time and returns when the robot is stationary again.
     *
     * @param mmPerSec speed, ahead positive
     * @param degPerSec turn rate, counterclockwise positive
     * @param seconds for how long; at most 60
     * @param until ends the motion early
     * @return how long it took, braking included
     */
    MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until);

    /**
     * Drives as a course says, and returns when the robot is stationary again.
     *
     * @param course asked again and again what to do next
     * @param until ends the motion early
     * @return what the course gives as its amount
     */
    MotionReport follow(Course course, Guard until);

    /**
     * Drives a curve from now on and returns at once. Unless it is called again within 600 ms, a stop is sent to the
     * robot.
     *
     * @param mmPerSec speed, ahead positive
     * @param degPerSec turn rate, counterclockwise positive
     */
    void drive(double mmPerSec, double degPerSec);

    /** Stops the robot, overtaking everything, from any thread; a motion under way throws {@link MotionStopped}. */
    void stop();

    /**
     * Reads a parameter, waiting for the robot's answer if it does not report it. An old reading is never returned as
     * the present value: by the rule of {@link Reading}, it is unknown.
     *
     * @param parameter its name, whatever the case
     * @return its value; {@link Value.Unknown} with the reason if there is no current reading, for instance because the
     *     connection is lost
     */
    default Value get(String parameter) {
        return reading(parameter).value();
    }

    /**
     * Reads a parameter as {@link #get} does, and returns its age, and the last value if it is not current.
     *
     * @param parameter its name, whatever the case
     * @return the last value, and whether it is current
     */
    Reading reading(String parameter);

    /**
     * Sets a parameter and returns when the robot has it, and when a motion that this is has ended.
     *
     * @param parameter its name, whatever the case
     * @param values its value, then any extras it takes
     */
    void set(String parameter, List<Value> values);

    /**
     * Runs one of the commands that only this type of robot has.
     *
     * @param command its name, whatever the case
     * @param arguments what it takes
     * @return its answer
     */
    default String run(String command, List<Value> arguments) {
        return run(command, arguments, Guard.NEVER);
    }

    /**
     * Runs one of the commands that only this type of robot has.
     *
     * @param command its name, whatever the case
     * @param arguments what it takes
     * @param until ends it early if it is a motion that can end early; else without effect
     * @return its answer
     */
    String run(String command, List<Value> arguments, Guard until);

    /**
     * Returns the parameters that can be read or set.
     *
     * @return the shared parameters and the robot's own
     */
    List<Parameter> parameters();

    /**
     * Returns the commands that only this type of robot has.
     *
     * @return its further commands
     */
    List<BotCommand> commands();

    /**
     * Drives straight all the way.
     *
     * @param mm as {@link #move(double, Guard)}
     * @return how far it went
     */
    default MotionReport move(double mm) {
        return move(mm, Guard.NEVER);
    }

    /**
     * Turns all the way.
     *
     * @param degrees as {@link #turn(double, Guard)}
     * @return how far it turned
     */
    default MotionReport turn(double degrees) {
        return turn(degrees, Guard.NEVER);
    }

    /**
     * Sets a parameter to a number in its own unit.
     *
     * @param parameter its name
     * @param number the value
     */
    default void set(String parameter, double number) {
        set(parameter, List.of(Value.of(number, Unit.NONE)));
    }

    /**
     * Sets a parameter to a word, {@code on} and {@code off} included.
     *
     * @param parameter its name
     * @param word the value
     */
    default void set(String parameter, String word) {
        set(parameter, List.of(Value.text(Objects.requireNonNull(word, "word"))));
    }
}
