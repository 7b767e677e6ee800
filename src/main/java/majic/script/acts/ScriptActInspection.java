package majic.script.acts;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.script.commands.ParameterCommands;
import majic.script.commands.TeamCommands;
import majic.script.run.Command;
import majic.script.run.Inspection;
import majic.script.run.Statement;
import majic.script.syntax.Condition;
import majic.script.syntax.Cursor;
import majic.script.syntax.EachComparison;
import majic.script.syntax.Late;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import org.jspecify.annotations.Nullable;

/**
 * Collects which robots a behaviour names, what each of them must have, and the commands in it that only a session may
 * contain.
 */
final class ScriptActInspection extends Inspection {
    private static final Pattern NAME = Pattern.compile("\\w+");

    /** In place of a number, for {@code me}. */
    static final int ME = 0;

    /** In place of a number, for {@code all}. */
    private static final int ALL = -1;

    private static final Pattern TYPE = Pattern.compile("\\w+");

    private final Map<Integer, String> types = new HashMap<>();
    private final Map<Integer, Set<String>> parameters = new HashMap<>();
    private final Map<Integer, Set<String>> commands = new HashMap<>();
    private final Set<Integer> numbers = new LinkedHashSet<>();
    private final List<Statement.ForRobots> ownCommands = new ArrayList<>();
    private boolean hasMe;

    /** Whether {@code me} occurs in it. */
    boolean hasMe() {
        return hasMe;
    }

    /** The numbers of robots in it, in the order of their first use. */
    Set<Integer> numbers() {
        return numbers;
    }

    /** The types of robots, where the behaviour shows them. */
    Map<Integer, String> types() {
        return types;
    }

    /** The lines with commands that only some types have. */
    List<Statement.ForRobots> ownCommands() {
        return ownCommands;
    }

    /**
     * The parameters that a robot must have, as far as the script alone shows: a word that is compared with another
     * word may be a choice.
     *
     * @param number the robot's in the script, or {@link #ME}
     */
    List<String> parameters(int number) {
        return ofBoth(parameters, number);
    }

    /** The commands that a robot must have in addition to those of every robot. */
    List<String> commands(int number) {
        return ofBoth(commands, number);
    }

    private static List<String> ofBoth(Map<Integer, Set<String>> named, int number) {
        Set<String> all = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        all.addAll(named.getOrDefault(ALL, Set.of()));
        all.addAll(named.getOrDefault(number, Set.of()));
        return List.copyOf(all);
    }

    @Override
    public void inspect(Late<Condition> condition) {
        inspect(condition.sample(), null);
    }

    @Override
    public void readings(List<Cursor.Reading> readings) {
        readings.stream().filter(reading -> !reading.orPlace()).forEach(reading -> {
            robots(reading.robots());
            need(parameters, reading.robots(), reading.parameter().text());
        });
    }

    private void inspect(Condition condition, @Nullable Robots own) {
        condition.accept(new EachComparison(comparison -> {
            Robots asked = comparison.robots();
            if (asked != null) {
                robots(asked);
            }
            compare(comparison, asked == null ? own : asked);
        }));
    }

    /** A condition with {@code any} skips robots without the parameter. */
    private void compare(Condition.Comparison comparison, @Nullable Robots asked) {
        if (asked == null || asked.isAny()) {
            return;
        }
        need(parameters, asked, comparison.parameter().text());
        Literal value = comparison.value();
        boolean ordered = !comparison.operator().isEquality();
        if (ordered && value.at().kind() == Token.Kind.WORD && !value.text().equalsIgnoreCase("clear")) {
            need(parameters, asked, value.text());
        }
    }

    /** A word that cannot be the name of a parameter or command is left to the check against the robot. */
    private static void need(Map<Integer, Set<String>> needs, Robots robots, String name) {
        if (NAME.matcher(name).matches()) {
            for (Robots.Item item : robots.items()) {
                needs.computeIfAbsent(key(item), key -> new TreeSet<>(String.CASE_INSENSITIVE_ORDER))
                        .add(name);
            }
        }
    }

    private static int key(Robots.Item item) {
        if (item instanceof Robots.One one) {
            return one.number();
        }
        return item instanceof Robots.Me ? ME : ALL;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        if (line.command() instanceof TeamCommands.Name) {
            return null;
        }
        robots(line.robots());
        Command command = line.command();
        command.refusalInAct().ifPresent(why -> refuse(command.at(), why));
        Condition until = command.until();
        if (until != null) {
            inspect(until, line.robots());
        }
        if (command instanceof ParameterCommands.Own own) {
            ownCommands.add(line);
            need(commands, line.robots(), own.at().text());
        }
        command.parameters().forEach(name -> need(parameters, line.robots(), name.text()));
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        line.command().refusalInAct().ifPresent(why -> refuse(line.at(), why));
        if (line.command() instanceof TeamCommands.Add add) {
            add(line, add);
        }
        return null;
    }

    private static void refuse(Token word, String why) {
        throw new ScriptException(word, word.text().toLowerCase(Locale.ROOT) + ": " + why);
    }

    private void add(Statement.ForSession line, TeamCommands.Add add) {
        if (add.number().isEmpty()) {
            throw new ScriptException(line.at(), "add: an act is given its robots; leave the line out");
        }
        BotAddress address = BotAddress.parse(add.address().unquoted());
        if (!address.isOfAnotherDesk()) {
            String type = type(address);
            if (!TYPE.matcher(type).matches()) {
                throw new ScriptException(
                        add.address().at(),
                        "add: the type of a robot is letters and digits, as in pioneer://10.0.0.5 or sim:aibo");
            }
            types.put(add.number().getAsInt(), type);
        }
    }

    /** Several robots of one type in a lab have numbers: {@code sim:pioneer2}. */
    private static String type(BotAddress address) {
        return address.scheme().equals(BotAddress.SIMULATED)
                ? address.rest().replaceFirst("\\d+$", "")
                : address.type();
    }

    private void robots(Robots robots) {
        for (Robots.Item item : robots.items()) {
            if (item instanceof Robots.One one) {
                number(one);
            } else if (item instanceof Robots.Me) {
                hasMe = true;
            } else if (item instanceof Robots.Span || item instanceof Robots.Named) {
                throw new ScriptException(
                        item.at(), item.at().text() + ": an act names its robots one by one: me, 2, 3 or all");
            }
        }
    }

    private void number(Robots.One robot) {
        if (robot.number() < 1) {
            throw new ScriptException(robot.at(), robot.at().text() + ": robots have the numbers 1, 2, 3 and so on");
        }
        numbers.add(robot.number());
    }
}
