package majic.driver;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;

/**
 * A command that only one type of robot has, with what its driver does for it. Immutable.
 *
 * @param command its description
 * @param action what it does
 */
public record DriverCommand(BotCommand command, Action action) {
    /** The action of a command that only some robots have. */
    @FunctionalInterface
    public interface Action {
        /**
         * Runs the command, on the calling thread.
         *
         * @param arguments the checked arguments, in order
         * @param motion through which everything that moves is to be sent
         * @return the answer for the user
         * @throws BotException if the robot could not do it
         */
        String run(List<Value> arguments, Motion motion);
    }

    /**
     * A command with so many arguments and no more.
     *
     * @param name its word in MAJIC Script; letters and digits
     * @param arguments what it takes, in order; each is required, but the extras of the last one are not
     * @param moves whether it moves the robot or may do so, as a raw command may
     * @param help one line for users
     * @param action what it does
     */
    public DriverCommand(String name, List<Parameter> arguments, boolean moves, String help, Action action) {
        this(name, arguments, List.of(), moves, help, action);
    }

    /**
     * A command whose last arguments may be repeated.
     *
     * @param name its word in MAJIC Script; letters and digits
     * @param arguments what it takes, in order
     * @param repeated what may follow behind them, all of these in order and any number of times
     * @param moves whether it moves the robot or may do so
     * @param help one line for users
     * @param action what it does
     */
    public DriverCommand(
            String name,
            List<Parameter> arguments,
            List<Parameter> repeated,
            boolean moves,
            String help,
            Action action) {
        this(new BotCommand(name, arguments, repeated, moves, help, false), action);
    }

    /**
     * This command, marked as raw: it passes the user's text to the robot unchecked by MAJIC.
     *
     * @return the same otherwise
     */
    public DriverCommand asRaw() {
        return new DriverCommand(
                new BotCommand(
                        command.name(), command.arguments(), command.repeated(), command.moves(), command.help(), true),
                action);
    }
}
