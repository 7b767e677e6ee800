package majic.team;

import java.util.List;
import majic.bot.BotControl;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * One command to one robot, checked and ready to be carried out.
 *
 * @param text the command without the robot, as answers repeat it: {@code move 500}
 * @param moves whether it may move the robot, and so needs the robot to be free and no STOP latched
 * @param job what it does
 * @param asker returned with the answers, so that they can be routed to the source of the command; null for no
 *     particular source
 */
public record Order(
        String text, boolean moves, Job job, @Nullable Object asker) {
    /**
     * Creates an order without an asker.
     *
     * @param text the command without the robot, as answers repeat it
     * @param moves whether it may move the robot
     * @param job what it does
     */
    public Order(String text, boolean moves, Job job) {
        this(text, moves, job, null);
    }

    /**
     * Returns the same order with an asker.
     *
     * @param by what its answers carry; null for nothing
     * @return the order
     */
    public Order askedBy(@Nullable Object by) {
        return new Order(text, moves, job, by);
    }

    /** The work of an order, run when its turn comes. */
    @FunctionalInterface
    public interface Job {
        /**
         * Does the work, and blocks until it is done.
         *
         * @param robot the robot, under the permission the order was given with
         * @return the answers, each without the robot's number: {@code move 500: done (498 mm, 2.1 s)}
         * @throws BotException if it could not be done; the order has failed then
         */
        List<String> carryOut(BotControl robot);
    }
}
