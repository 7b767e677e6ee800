package majic.script;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.Role;
import majic.act.file.ActFile;
import majic.bot.Value;
import majic.script.record.SessionRecord;
import org.jspecify.annotations.Nullable;

/**
 * A behaviour that can be loaded onto a robot, with what is known before any of its code is loaded. Immutable.
 *
 * @param called what a line calls it: its name, or the path of its file
 * @param details its description
 * @param roles the robots it asks for, the one it is loaded onto first
 * @param arguments the values it may be given
 * @param file the act's file; null for a script
 */
public record ActOffer(
        String called,
        ActDetails details,
        List<Role> roles,
        List<ActArgument> arguments,
        @Nullable ActFile file) {
    /** Keeps copies of the lists. */
    public ActOffer {
        roles = List.copyOf(roles);
        arguments = List.copyOf(arguments);
    }

    /**
     * Returns the line that ends the acts on robots.
     *
     * @param robots their numbers
     * @return for instance {@code 1,2 act off}
     */
    public static String endLine(List<Integer> robots) {
        return numbers(robots) + " act off";
    }

    private static String numbers(List<Integer> robots) {
        return robots.stream().map(String::valueOf).collect(Collectors.joining(","));
    }

    /**
     * Returns the line that loads it onto a robot, with values for its arguments.
     *
     * @param me the number of the robot it is loaded onto
     * @param values by the names of the arguments; what equals the default is left out
     * @param others the numbers of the further robots, in the order of the roles
     * @return for instance {@code 1 act Convoy distance=400mm with 2,3}
     */
    public String line(int me, Map<String, Value> values, List<Integer> others) {
        StringBuilder line = new StringBuilder(me + " act " + SessionRecord.quoted(called));
        for (ActArgument argument : arguments) {
            Value value = values.getOrDefault(argument.name(), argument.initial());
            if (!value.equals(argument.initial())) {
                line.append(' ').append(argument.name()).append('=').append(ActArgument.typed(value));
            }
        }
        String with = numbers(others);
        return line + (with.isEmpty() ? "" : " with " + with);
    }
}
