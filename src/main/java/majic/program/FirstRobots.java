package majic.program;

import java.util.List;
import majic.bot.BotException;

/**
 * The robots that are added when a program starts, each by a line of MAJIC Script.
 *
 * @param ofLab robots of the simulated lab; each line states the number of its robot, so their order does not matter
 * @param requested robots that the user has requested, which get the next free numbers in this order
 */
public record FirstRobots(List<String> ofLab, List<String> requested) {
    /** Determines the robots to add to a program. */
    @FunctionalInterface
    public interface Source {
        /**
         * Returns the robots to add; may start the lab that they are in.
         *
         * @throws BotException if that cannot be started
         */
        FirstRobots firstRobots(Program program);
    }

    /** No robot. */
    public static final FirstRobots NONE = new FirstRobots(List.of(), List.of());

    /** Copies the lists. */
    public FirstRobots {
        ofLab = List.copyOf(ofLab);
        requested = List.copyOf(requested);
    }
}
