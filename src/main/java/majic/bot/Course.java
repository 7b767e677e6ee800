package majic.bot;

import org.jspecify.annotations.Nullable;

/**
 * A way that is decided while a robot drives it: it is asked again and again what the robot does next. A stop, a lost
 * connection or a guard ends the motion whatever the course says.
 */
public interface Course {
    /** How often a course is asked while the robot drives or waits, seconds. */
    double PERIOD_S = 0.05;

    /** What a robot does next. */
    sealed interface Step {}

    /**
     * Drives until the course is asked again; 0 and 0 is standing still. What is outside of the robot's limits is
     * reduced to them.
     *
     * @param mmPerSec the speed, ahead positive
     * @param degPerSec the turn rate, counterclockwise positive
     */
    record Drive(double mmPerSec, double degPerSec) implements Step {
        /** Standing still. */
        public static final Drive STAND = new Drive(0, 0);
    }

    /**
     * Turns on the spot, as precisely as the robot can; the course is asked again when the robot is stationary.
     *
     * @param degrees the angle, counterclockwise positive
     */
    record Turn(double degrees) implements Step {}

    /**
     * Drives straight, as precisely as the robot can: for robots that do that better than by speeds. The course is
     * asked again when the robot is stationary; meanwhile {@link #isBlocked} may end it.
     *
     * @param mm the distance, ahead positive
     */
    record Move(double mm) implements Step {}

    /**
     * Stops: the robot is where it should be.
     *
     * @param amount what the answer shows; null for nothing
     */
    record Arrived(@Nullable Value amount) implements Step {}

    /**
     * Decides what the robot does next. Called on the thread of the motion, every {@value #PERIOD_S} s of the robot's
     * clock and after each turn or move; must not wait.
     *
     * @return the step
     * @throws MotionFailed if it cannot go on; the robot is stopped, and the motion fails with this reason
     */
    Step next();

    /**
     * Returns whether the present {@link Move} has to end. Asked as often as {@link #next}, on the same thread.
     *
     * @return true if something is in the way
     */
    default boolean isBlocked() {
        return false;
    }

    /**
     * Returns what a motion that its guard ended shows in its answer.
     *
     * @return null for nothing
     */
    default @Nullable Value amount() {
        return null;
    }
}
