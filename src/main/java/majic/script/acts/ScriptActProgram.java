package majic.script.acts;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.act.ActArgument;
import majic.act.Role;
import majic.bot.BotException;
import majic.bot.Value;
import majic.script.commands.ScriptParser;
import majic.script.commands.TeamCommands;
import majic.script.conditions.Selection;
import majic.script.run.Checker;
import majic.script.run.Command;
import majic.script.run.SessionState;
import majic.script.run.Statement;
import majic.script.syntax.Mistake;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;

/**
 * MAJIC Script as a behaviour: robot commands and control flow, for {@code me} and for robots by number. Of a saved
 * session the lines that add robots show the types of the robots, and their names are ignored. All other commands for a
 * session are refused.
 */
public final class ScriptActProgram {
    private final List<Statement> statements;
    private final ScriptActInspection found;
    private final List<ActArgument> arguments;

    private ScriptActProgram(List<Statement> statements, ScriptActInspection found, List<ActArgument> arguments) {
        this.statements = statements;
        this.found = found;
        this.arguments = List.copyOf(arguments);
    }

    /**
     * Reads a behaviour.
     *
     * @param title the name in messages about its mistakes
     * @param text the script
     * @param given the values of its arguments by name in lower case; an argument without one has its default
     * @return the behaviour
     * @throws BotException if it has mistakes, all of them in one message, each with its place
     */
    public static ScriptActProgram of(String title, String text, Map<String, Value> given) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = ScriptParser.parse(text, List.of(), given, mistakes);
        ScriptActInspection found = new ScriptActInspection();
        found.walk(script);
        mistakes.addAll(found.mistakes());
        if (mistakes.isEmpty() && found.numbers().isEmpty() && !found.hasMe()) {
            mistakes.add(new Mistake(1, 1, "no robot is commanded; write \"me\" or a number in front"));
        }
        List<ActArgument> arguments = arguments(script, mistakes);
        refuse(title, mistakes);
        return new ScriptActProgram(
                script.stream().filter(statement -> !isForSession(statement)).toList(), found, arguments);
    }

    private static List<ActArgument> arguments(List<Statement> script, List<Mistake> mistakes) {
        List<ActArgument> arguments = new ArrayList<>();
        for (Statement statement : script) {
            if (statement instanceof Statement.Argument argument) {
                try {
                    arguments.add(new ActArgument(argument.parameter(), argument.initial()));
                } catch (IllegalArgumentException e) {
                    Token at = argument.at();
                    mistakes.add(new Mistake(at.line(), at.column(), String.valueOf(e.getMessage())));
                }
            }
        }
        return arguments;
    }

    /**
     * Checks whether robots can do what it commands.
     *
     * @param byRole the robots by role
     * @return what is wrong, in any order
     */
    public List<Mistake> check(SessionState session, Map<String, Member> byRole) {
        Selection robots = among(byRole);
        List<Mistake> mistakes = new ArrayList<>(Checker.check(statements, session, robots));
        mistakes.addAll(rawCommands(robots));
        return mistakes;
    }

    /**
     * Refuses a script with mistakes.
     *
     * @throws BotException if there are any, one line for each
     */
    public static void refuse(String title, List<Mistake> mistakes) {
        if (!mistakes.isEmpty()) {
            throw new BotException(String.join("; ", Mistake.inOrder(mistakes, title)));
        }
    }

    /** Whether a line of a saved session adds or names a robot. */
    private static boolean isForSession(Statement statement) {
        return (statement instanceof Statement.ForSession line && line.command() instanceof TeamCommands.Add)
                || (statement instanceof Statement.ForRobots named && named.command() instanceof TeamCommands.Name);
    }

    /** What is run, without the lines that add and name robots. */
    public List<Statement> statements() {
        return statements;
    }

    /** Returns the arguments it begins with, with their defaults. */
    public List<ActArgument> arguments() {
        return arguments;
    }

    /** Without {@code me} in the script, it runs on the robot named first. */
    public List<Role> roles() {
        return List.copyOf(roleByNumber().values());
    }

    /** Finds the robots that it names among those assigned to its roles. */
    public Selection among(Map<String, Member> byRole) {
        Map<Integer, Member> byNumber = new LinkedHashMap<>();
        roleByNumber().forEach((number, role) -> byNumber.put(number, byRole.get(role.name())));
        byNumber.remove(ScriptActInspection.ME);
        return new Selection(byRole.get(Role.ME), byNumber);
    }

    /** The key 0 is {@code me}, if it occurs in the script. */
    private Map<Integer, Role> roleByNumber() {
        Map<Integer, Role> roles = new LinkedHashMap<>();
        if (found.hasMe()) {
            roles.put(ScriptActInspection.ME, role(Role.ME, ScriptActInspection.ME));
        }
        for (int number : found.numbers()) {
            Role role = role(roles.isEmpty() ? Role.ME : "robot" + number, number);
            String type = found.types().get(number);
            roles.put(number, type == null ? role : role.types(type));
        }
        return roles;
    }

    private Role role(String name, int number) {
        return Role.any(name)
                .with(found.parameters(number).toArray(String[]::new))
                .calling(found.commands(number).toArray(String[]::new));
    }

    /** Which commands of a robot are raw depends on the robot. */
    private List<Mistake> rawCommands(Selection robots) {
        return found.ownCommands().stream()
                .filter(line ->
                        robots.present(line.robots()).stream().anyMatch(member -> isRaw(line.command(), member)))
                .map(line -> new ScriptException(
                                line.command().at(), line.command().at().text() + ": an act gives no raw commands")
                        .mistake())
                .toList();
    }

    private static boolean isRaw(Command command, Member member) {
        return member.bot().commands().stream()
                .anyMatch(known -> known.raw()
                        && known.name().equalsIgnoreCase(command.at().text()));
    }
}
