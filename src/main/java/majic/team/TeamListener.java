package majic.team;

import java.util.Collection;
import java.util.List;

/**
 * Is called with news of a team, on worker threads: be quick, and cross over to another thread for anything slow. A
 * listener that blocks holds up later orders and other listeners, but no stop.
 */
public interface TeamListener {
    /**
     * A command was answered.
     *
     * @param answer the answer
     */
    default void answered(Answer answer) {}

    /**
     * A robot, or the program about a robot, has something to say.
     *
     * @param robot its number
     * @param message the whole line, with the number
     */
    default void noticed(int robot, String message) {}

    /**
     * A robot's connection was lost.
     *
     * @param member who
     * @param reason how, as half a sentence
     */
    default void lost(Member member, String reason) {}

    /**
     * A robot whose connection was lost is connected again.
     *
     * @param member who
     */
    default void regained(Member member) {}

    /**
     * A robot joined.
     *
     * @param member who
     */
    default void added(Member member) {}

    /**
     * A robot left and is closed.
     *
     * @param member who it was
     */
    default void removed(Member member) {}

    /**
     * A robot has another owner, or none.
     *
     * @param member which robot; ask it who
     */
    default void ownerChanged(Member member) {}

    /**
     * A person has driven a robot by hand, or set by hand what moves it, and let it go.
     *
     * @param member which robot
     * @param commands what was done, oldest first; at least one
     */
    default void drivenByHand(Member member, List<ManualCommand> commands) {}

    /**
     * A person has stopped some robots, but not all by STOP; told when the stops are being written to the robots.
     *
     * @param members which
     */
    default void stopped(Collection<Member> members) {}

    /**
     * STOP was pressed or released; told in that order, when the stops are being written to the robots. By the time of
     * the call {@link Team#isLatched()} may differ already.
     *
     * @param latched whether motion was refused from then on
     */
    default void latchChanged(boolean latched) {}
}
