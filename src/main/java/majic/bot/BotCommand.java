package majic.bot;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * A command that only one type of robot has, such as {@code calibrate}. Immutable.
 *
 * @param name its word in MAJIC Script; letters and digits
 * @param arguments what it takes, in order; each is required
 * @param repeated what may follow behind them, all of these in order and any number of times
 * @param moves whether it moves the robot or may do so, as a raw command may; it then needs the robot to be free
 * @param help one line for people
 * @param action what it does
 */
public record BotCommand(
        String name, List<Parameter> arguments, List<Parameter> repeated, boolean moves, String help, Action action) {

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

    /** Keeps copies of the arguments. */
    public BotCommand {
        arguments = List.copyOf(arguments);
        repeated = List.copyOf(repeated);
    }

    /**
     * A command with so many arguments and no more.
     *
     * @param name its word
     * @param arguments what it takes, in order; each is required
     * @param moves whether it moves the robot or may do so
     * @param help one line for people
     * @param action what it does
     */
    public BotCommand(String name, List<Parameter> arguments, boolean moves, String help, Action action) {
        this(name, arguments, List.of(), moves, help, action);
    }

    /**
     * How it is written.
     *
     * @return its name with the names of its arguments: {@code tones DURATION NOTE [DURATION NOTE]...}
     */
    public String usage() {
        return (name + " " + argumentNames()).strip();
    }

    /** The names of its arguments as people read them. */
    String argumentNames() {
        return repeated.isEmpty() ? names(arguments) : names(arguments) + " [" + names(repeated) + "]...";
    }

    private static String names(List<Parameter> some) {
        return some.stream()
                .map(argument -> argument.name().toUpperCase(Locale.ROOT))
                .collect(Collectors.joining(" "));
    }

    /**
     * What is to stand at a place behind its name.
     *
     * @param index 0 for the first place
     * @return null where nothing more is expected
     */
    public @Nullable Parameter argument(int index) {
        if (index < arguments.size()) {
            return arguments.get(index);
        }
        return repeated.isEmpty() ? null : repeated.get((index - arguments.size()) % repeated.size());
    }

    /** Whether it can be given so many arguments. */
    boolean takes(int count) {
        int further = count - arguments.size();
        return further == 0 || further > 0 && !repeated.isEmpty() && further % repeated.size() == 0;
    }
}
