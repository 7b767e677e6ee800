package majic.velocity;

import majic.bot.BotState;
import majic.driver.RobotWait;

/** What the motions of a base use of its driver. */
public interface BaseOwner {
    /** The name of the robot in messages. */
    String name();

    /** The clock, and the signal that is raised after each reading, stop and change of the connection. */
    RobotWait waiting();

    /** The contact sensors of the robot. */
    ObstructionSource obstructions();

    /** How long a message takes to the robot's server and back at present, s; 0 if that is not known. */
    double roundTripS();

    /**
     * Runs a task once on the timer thread of the robot.
     *
     * @param what its name; a task of the same name is replaced
     * @param seconds from now
     * @param task quick
     */
    void once(String what, double seconds, Runnable task);

    /**
     * Runs a task again and again on the timer thread of the robot.
     *
     * @param what its name; a task of the same name is replaced
     * @param seconds the period
     * @param task quick
     */
    void every(String what, double seconds, Runnable task);

    /** Publishes the state of the base, on the thread that reported a reading. */
    void publish(BotState state);

    /** Sends a notice to the user. */
    void notice(String message);
}
