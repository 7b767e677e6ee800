package majic.shared.desk;

import java.util.Set;
import majic.shared.message.Sender;

/**
 * What a desk shares, and under which name. Immutable.
 *
 * @param site one or more levels with slashes between them
 * @param desk the name of the desk: a letter, then letters, digits, - and _, at most 20 characters in all
 * @param person the name of its user, as others see it
 * @param program name and version of the program
 * @param robots the numbers of the robots to share; empty for all but those that are reached through a broker
 *     themselves
 * @param vda5050 whether the robots are published as vehicles of VDA 5050, too
 */
public record DeskOptions(
        String site, String desk, String person, String program, Set<Integer> robots, boolean vda5050) {
    /**
     * Keeps a copy of the numbers.
     *
     * @throws majic.bot.BotException if the desk's name cannot be one
     */
    public DeskOptions {
        Sender.checkDesk(desk);
        robots = Set.copyOf(robots);
    }
}
