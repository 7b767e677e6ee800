package majic.shared.vda5050;

import java.util.Optional;
import java.util.function.Consumer;
import majic.team.Member;

/** A robot as the fleet tools need it: they read it, and stop it. */
public interface StoppableRobot {
    /**
     * Returns the robot.
     *
     * @return a member of a team
     */
    Member member();

    /**
     * Stops the robot, whatever moves it; returns at once.
     *
     * @param by name of the sender, for messages
     * @param result called when the robot has confirmed the stop, or with the reason why it has not
     */
    void stop(String by, Consumer<Optional<String>> result);

    /**
     * Reports a problem to the user of the desk. Returns at once.
     *
     * @param words what is wrong, as a sentence
     */
    void notice(String words);
}
