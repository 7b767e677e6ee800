package majic.act;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.bot.BotCommand;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * Describes a robot that an act needs: its name in the act and the types, parameters and commands it must have.
 * Immutable.
 *
 * @param name the role's name, letters and digits; {@value #ME} is the robot the act is loaded onto
 * @param types the permitted types of robots, as in addresses; empty for any
 * @param parameters the parameters it must have
 * @param commands the further commands it must have, beside those that every robot has
 * @param several whether several robots may take the role; used for the last role of an act
 */
public record Role(String name, List<String> types, List<String> parameters, List<String> commands, boolean several) {
    /** The role of the robot that an act is loaded onto. */
    public static final String ME = "me";

    /** The suffix that distinguishes a command from a parameter. */
    private static final String CALL = "()";

    /** Commands that only aircraft have, in lower case: a role that needs one is for them. */
    private static final Set<String> OF_AIRCRAFT = Set.of("takeoff", "climb");

    private static final Pattern TEXT =
            Pattern.compile("(\\w+)(\\+?)(?: (\\w+(?:\\|\\w+)*))?(?: \\((\\w+(?:\\(\\))?(?:,\\w+(?:\\(\\))?)*)\\))?");

    /**
     * Keeps copies of the lists.
     *
     * @throws IllegalArgumentException if a name is not letters and digits, or if {@value #ME} is to be several robots
     */
    public Role {
        types = types.stream().map(type -> type.toLowerCase(Locale.ROOT)).toList();
        parameters = List.copyOf(parameters);
        commands = List.copyOf(commands);
        if (!TEXT.matcher(textOf(name, types, needs(parameters, commands))).matches()) {
            throw new IllegalArgumentException(
                    "a role is named in letters and digits, with types, parameters and commands");
        }
        if (several && name.equals(ME)) {
            throw new IllegalArgumentException("an act is loaded onto one robot, so " + ME + " is not several");
        }
    }

    /**
     * Returns a role for any robot.
     *
     * @param name the role's name, letters and digits
     * @return a role without further requirements
     */
    public static Role any(String name) {
        return new Role(name, List.of(), List.of(), List.of(), false);
    }

    /**
     * Returns this role restricted to some types of robots.
     *
     * @param wanted the required types, as in addresses: {@code aibo}
     * @return a role with the same parameters and commands
     */
    public Role types(String... wanted) {
        return new Role(name, List.of(wanted), parameters, commands, several);
    }

    /**
     * Returns this role restricted to robots with some parameters.
     *
     * @param wanted the required parameters' names: {@code distanceFront}
     * @return a role for the same types, with the same commands
     */
    public Role with(String... wanted) {
        return new Role(name, types, List.of(wanted), commands, several);
    }

    /**
     * Returns this role restricted to robots with some type-specific commands.
     *
     * @param wanted the required commands' names: {@code play}
     * @return a role for the same types, with the same parameters
     */
    public Role calling(String... wanted) {
        return new Role(name, types, parameters, List.of(wanted), several);
    }

    /**
     * Returns this role for one or more robots, as many as the user assigns. Only the last role of an act can be of
     * this kind.
     *
     * @return a role with the same requirements
     * @throws IllegalArgumentException if it is {@value #ME}
     */
    public Role orMore() {
        return new Role(name, types, parameters, commands, true);
    }

    /**
     * Returns whether the role is for robots that leave the ground: it needs a command that only those have. Any other
     * role is for robots on the ground or on the water.
     */
    public boolean isForAircraft() {
        return commands.stream().anyMatch(command -> OF_AIRCRAFT.contains(command.toLowerCase(Locale.ROOT)));
    }

    /** Returns whether a robot leaves the ground, and the role is for robots that do not. */
    public boolean refusesAircraft(MajicBot robot) {
        return robot.profile().leavesGround() && !isForAircraft();
    }

    /**
     * Returns why a robot cannot take this role.
     *
     * @param robot the robot; no command is sent to it
     * @return what the robot lacks, to put behind its number ({@code has no parameter sonar3}); empty if it is suitable
     */
    public Optional<String> unfit(MajicBot robot) {
        String type = robot.type().name();
        if (!takes(type)) {
            return Optional.of("is of type " + type + ", not " + String.join(" or ", types));
        }
        if (refusesAircraft(robot)) {
            return Optional.of("leaves the ground, and the act is for robots on the ground");
        }
        return missingParameter(robot)
                .map(one -> "has no parameter " + one + Suggestion.didYouMean(one, parametersOf(robot)))
                .or(() -> missingCommand(robot)
                        .map(one -> "has no command " + one + Suggestion.didYouMean(one, commandsOf(robot))));
    }

    /**
     * Returns whether robots of a type may take this role.
     *
     * @param type the type as in addresses, in any case
     */
    public boolean takes(String type) {
        return types.isEmpty() || types.contains(type.toLowerCase(Locale.ROOT));
    }

    /** Returns the first parameter that a robot would need for this role and lacks; empty if it has all. */
    public Optional<String> missingParameter(MajicBot robot) {
        return missing(parameters, parametersOf(robot));
    }

    /** Returns the first command that a robot would need for this role and lacks; empty if it has all. */
    public Optional<String> missingCommand(MajicBot robot) {
        return missing(commands, commandsOf(robot));
    }

    private static Optional<String> missing(List<String> wanted, List<String> has) {
        return wanted.stream()
                .filter(one -> has.stream().noneMatch(one::equalsIgnoreCase))
                .findFirst();
    }

    private static List<String> parametersOf(MajicBot robot) {
        return robot.parameters().stream().map(Parameter::name).toList();
    }

    private static List<String> commandsOf(MajicBot robot) {
        return robot.commands().stream().map(BotCommand::name).toList();
    }

    /**
     * Reads a role from the form that {@link #toString()} gives.
     *
     * @param text for instance {@code me aibo|pioneer (distanceFront,bumped)}
     * @return the role
     * @throws IllegalArgumentException if the text is not a role
     */
    public static Role parse(String text) {
        Matcher parts = TEXT.matcher(text.strip());
        if (!parts.matches()) {
            throw new IllegalArgumentException("'" + text + "' is not a role, as in: me aibo|pioneer (distanceFront)");
        }
        boolean several = !parts.group(2).isEmpty();
        List<String> needs = listed(parts.group(4), ",");
        return new Role(
                parts.group(1),
                listed(parts.group(3), "\\|"),
                needs.stream().filter(need -> !need.endsWith(CALL)).toList(),
                needs.stream()
                        .filter(need -> need.endsWith(CALL))
                        .map(need -> need.substring(0, need.length() - CALL.length()))
                        .toList(),
                several);
    }

    private static List<String> listed(@Nullable String text, String separator) {
        return text == null ? List.of() : List.of(text.split(separator));
    }

    /**
     * Returns the role as shown and typed: {@code me aibo|pioneer (distanceFront,play())}; {@code follower+} for
     * several.
     */
    @Override
    public String toString() {
        return textOf(several ? name + "+" : name, types, needs());
    }

    /**
     * Returns the parameters and commands that the robot must have, as in {@link #toString()}.
     *
     * @return the parameters by name, then the commands with brackets: {@code play()}
     */
    public List<String> needs() {
        return needs(parameters, commands);
    }

    private static List<String> needs(List<String> parameters, List<String> commands) {
        return Stream.concat(parameters.stream(), commands.stream().map(command -> command + CALL))
                .toList();
    }

    private static String textOf(String name, List<String> types, List<String> needs) {
        String ofTypes = types.isEmpty() ? "" : " " + String.join("|", types);
        return name + ofTypes + (needs.isEmpty() ? "" : " (" + String.join(",", needs) + ")");
    }
}
