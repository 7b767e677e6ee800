package majic.team;

import java.util.Collection;
import java.util.List;

/**
 * Receives events of a team, on worker threads: return quickly, and use another thread for anything slow. A listener
 * that blocks delays later commands and other listeners, but no stop.
 */
public interface TeamListener {
    /**
     * A command was answered.
     *
     * @param answer the answer
     */
    default void answered(Answer answer) {}

    /**
     * A robot, or the program on behalf of a robot or of the team, issued a message.
     *
     * @param robot its number; 0 for the team
     * @param message the whole line, with the number of the robot
     */
    default void noticed(int robot, String message) {}

    /**
     * A robot's connection was lost.
     *
     * @param member the robot
     * @param reason how, as half a sentence
     */
    default void lost(Member member, String reason) {}

    /**
     * A robot whose connection was lost is connected again.
     *
     * @param member the robot
     */
    default void regained(Member member) {}

    /**
     * A robot was added.
     *
     * @param member the robot
     */
    default void added(Member member) {}

    /**
     * A robot was removed and is closed.
     *
     * @param member the removed robot
     */
    default void removed(Member member) {}

    /**
     * A robot was given a name, another one, or none.
     *
     * @param member the robot; query it for the name
     */
    default void renamed(Member member) {}

    /**
     * A robot has another owner, or none.
     *
     * @param member the robot; query it for the owner
     */
    default void ownerChanged(Member member) {}

    /**
     * A user has driven a robot manually, or set parameters that move it, and released it.
     *
     * @param member the robot
     * @param commands what was done, oldest first; at least one
     */
    default void drivenManually(Member member, List<ManualCommand> commands) {}

    /**
     * Some robots have not confirmed a stop yet, and do not report that they slow down; their drivers still wait for
     * the confirmation. Whether they confirm it is reported later, as for every stop.
     *
     * @param members the robots, at least one
     * @param seconds the time since the stop was written
     */
    default void stopOverdue(Collection<Member> members, double seconds) {}

    /**
     * A user has stopped robots, some of them or all by STOP; called when the stops are being written to the robots.
     *
     * @param members the stopped robots
     * @param atNanos when the stop was requested, on the clock of the team
     */
    default void stopped(Collection<Member> members, long atNanos) {}

    /**
     * STOP was pressed or released; called in that order, when the stops are being written to the robots. By the time
     * of the call {@link Team#isLatched()} may differ already.
     *
     * @param latched whether motion was refused from then on
     */
    default void latchChanged(boolean latched) {}

    /**
     * A robot has confirmed its stop or failed to, or such a state has ended; called in the order of the changes, after
     * the stops were passed to the threads that write them.
     *
     * @param status the state after the change
     */
    default void stopStatusChanged(StopStatus status) {}
}
