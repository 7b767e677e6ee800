package majic.bot;

import java.util.List;

/**
 * A command that only one type of robot has, such as {@code calibrate}. Immutable.
 *
 * @param name its word in MAJIC Script; letters and digits
 * @param arguments what it takes, in order; each is required
 * @param moves whether it moves the robot or may do so, as a raw command may; it then needs the robot to be free
 * @param help one line for people
 * @param action what it does
 */
public record BotCommand(String name, List<Parameter> arguments, boolean moves, String help, Action action) {

    /** What a robot's own command does. */
    @FunctionalInterface
    public interface Action {
        /**
         * Runs the command, on the thread of whoever asked for it.
         *
         * @param arguments the checked arguments, in order
         * @param motion through which everything that moves is to be sent
         * @return the answer for the person
         * @throws BotException if the robot could not do it
         */
        String run(List<Value> arguments, Motion motion);
    }

    /** Keeps a copy of the arguments. */
    public BotCommand {
        arguments = List.copyOf(arguments);
    }
}
