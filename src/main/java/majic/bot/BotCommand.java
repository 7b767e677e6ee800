package majic.bot;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * A command that only one type of robot has, such as {@code calibrate}. Immutable.
 *
 * @param name its word in MAJIC Script; letters and digits
 * @param arguments what it takes, in order; each is required, but the extras of the last one are not
 * @param repeated what may follow behind them, all of these in order and any number of times; empty where the last
 *     argument has extras
 * @param moves whether it moves the robot or may do so, as a raw command may; it then needs the robot to be free
 * @param help one line for users
 * @param raw whether it passes the user's text to the robot unchecked by MAJIC; not allowed in behaviours written in
 *     MAJIC Script
 */
public record BotCommand(
        String name, List<Parameter> arguments, List<Parameter> repeated, boolean moves, String help, boolean raw) {

    /** Keeps copies of the arguments. */
    public BotCommand {
        arguments = List.copyOf(arguments);
        repeated = List.copyOf(repeated);
    }

    /**
     * Returns the syntax of the command.
     *
     * @return its name with the names of its arguments: {@code tones DURATION NOTE [DURATION NOTE]...}
     */
    public String usage() {
        return (name + " " + argumentNames()).strip();
    }

    /**
     * Returns the names of its arguments in upper case, optional ones in brackets.
     *
     * @return empty for a command without arguments
     */
    public String argumentNames() {
        String optional = optional().stream()
                .map(extra -> " [" + names(List.of(extra)) + "]")
                .collect(Collectors.joining());
        return (names(arguments) + optional + (repeated.isEmpty() ? "" : " [" + names(repeated) + "]...")).strip();
    }

    private List<Parameter> optional() {
        return arguments.isEmpty()
                ? List.of()
                : arguments.get(arguments.size() - 1).extras();
    }

    private static String names(List<Parameter> some) {
        return some.stream()
                .map(argument -> argument.name().toUpperCase(Locale.ROOT))
                .collect(Collectors.joining(" "));
    }

    /**
     * Returns the argument at a place behind the name.
     *
     * @param index 0 for the first place
     * @return null where nothing more is expected
     */
    public @Nullable Parameter argument(int index) {
        if (index < arguments.size()) {
            return arguments.get(index);
        }
        int further = index - arguments.size();
        if (further < optional().size()) {
            return optional().get(further);
        }
        return repeated.isEmpty() ? null : repeated.get(further % repeated.size());
    }

    /**
     * Returns whether the command accepts a number of arguments.
     *
     * @param count 0 or more
     * @return whether {@link MajicBot#run(String, java.util.List)} accepts so many
     */
    public boolean takes(int count) {
        int further = count - arguments.size();
        boolean rounds = further > 0 && !repeated.isEmpty() && further % repeated.size() == 0;
        return rounds || further >= 0 && further <= optional().size();
    }
}
