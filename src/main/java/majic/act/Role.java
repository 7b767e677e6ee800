package majic.act;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.bot.BotCommand;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * A robot that an act asks for: what the act calls it, and what it has to be able to do. Immutable.
 *
 * @param name the act's word for it, letters and digits; {@value #ME} is the robot the act is loaded onto
 * @param types the types of robots that will do, as in addresses; empty for any
 * @param parameters the parameters it must have
 * @param commands the further commands it must have, beside those that every robot has
 * @param several whether further robots may play it too; of use for the last role of an act
 */
public record Role(String name, List<String> types, List<String> parameters, List<String> commands, boolean several) {
    /** The role of the robot that an act is loaded onto. */
    public static final String ME = "me";

    /** How a command is told from a parameter. */
    private static final String CALL = "()";

    private static final Pattern TEXT =
            Pattern.compile("(\\w+)(\\+?)(?: (\\w+(?:\\|\\w+)*))?(?: \\((\\w+(?:\\(\\))?(?:,\\w+(?:\\(\\))?)*)\\))?");

    /**
     * Keeps copies of the lists.
     *
     * @throws IllegalArgumentException if a name is not letters and digits, or several robots shall be {@value #ME}
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
     * A role for any robot.
     *
     * @param name the act's word for it
     * @return a role with no further needs
     */
    public static Role any(String name) {
        return new Role(name, List.of(), List.of(), List.of(), false);
    }

    /**
     * This role, for robots of some types only.
     *
     * @param wanted the types, as in addresses: {@code aibo}
     * @return a role with the same parameters and commands
     */
    public Role types(String... wanted) {
        return new Role(name, List.of(wanted), parameters, commands, several);
    }

    /**
     * This role, for robots that have some parameters.
     *
     * @param wanted their names: {@code distanceFront}
     * @return a role for the same types, with the same commands
     */
    public Role with(String... wanted) {
        return new Role(name, types, List.of(wanted), commands, several);
    }

    /**
     * This role, for robots that have some commands of their own.
     *
     * @param wanted their names: {@code play}
     * @return a role for the same types, with the same parameters
     */
    public Role calling(String... wanted) {
        return new Role(name, types, parameters, List.of(wanted), several);
    }

    /**
     * This role, for one robot or as many as the user assigns. Only the last role of an act can be of this kind.
     *
     * @return a role with the same needs
     * @throws IllegalArgumentException if it is {@value #ME}
     */
    public Role orMore() {
        return new Role(name, types, parameters, commands, true);
    }

    /**
     * Why a robot cannot play this role.
     *
     * @param robot the robot; nothing is asked of it
     * @return what it lacks, to put behind the robot's number ({@code has no parameter sonar3}); empty if it will do
     */
    public Optional<String> unfit(MajicBot robot) {
        String type = robot.type().name();
        if (!types.isEmpty() && !types.contains(type.toLowerCase(Locale.ROOT))) {
            return Optional.of("is of type " + type + ", not " + String.join(" or ", types));
        }
        List<String> has = robot.parameters().stream().map(Parameter::name).toList();
        List<String> calls = robot.commands().stream().map(BotCommand::name).toList();
        return missing("parameter", parameters, has).or(() -> missing("command", commands, calls));
    }

    private static Optional<String> missing(String kind, List<String> wanted, List<String> has) {
        return wanted.stream()
                .filter(one -> has.stream().noneMatch(one::equalsIgnoreCase))
                .findFirst()
                .map(one -> "has no " + kind + " " + one + Suggestion.didYouMean(one, has));
    }

    /**
     * Reads a role from the form that {@link #toString()} gives.
     *
     * @param text for instance {@code me aibo|pioneer (distanceFront,bumped)}
     * @return the role
     * @throws IllegalArgumentException if the text is none
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

    /** The role as one reads and types it: {@code me aibo|pioneer (distanceFront,play())}; {@code follower+} for several. */
    @Override
    public String toString() {
        return textOf(several ? name + "+" : name, types, needs());
    }

    /**
     * All that the robot must have, as in {@link #toString()}.
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
