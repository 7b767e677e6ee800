package majic.bot;

import java.util.Collection;
import java.util.List;

/** Hears of a team. Called on worker threads: be quick, and cross over to another thread for anything slow. */
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
     * A person stops some robots, but not all by STOP; told before they are.
     *
     * @param members which
     */
    default void stopped(Collection<Member> members) {}

    /**
     * STOP was pressed or released.
     *
     * @param latched whether motion is refused from now on
     */
    default void latchChanged(boolean latched) {}
}
