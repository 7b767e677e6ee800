package majic.script;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import majic.act.Role;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Member;
import org.jspecify.annotations.Nullable;

/**
 * What MAJIC Script says as a behaviour: robot commands and control flow, for {@code me} and for robots by number. Of a
 * saved session the lines that add robots count as saying of which type they are. Everything else of a session is refused.
 */
final class Behaviour implements Statement.Visitor<@Nullable Void> {
    private final List<Statement> statements = new ArrayList<>();
    private final List<Mistake> mistakes = new ArrayList<>();
    private final Map<Integer, String> types = new HashMap<>();
    private final Set<Integer> numbers = new LinkedHashSet<>();
    private final List<Statement.ForRobots> own = new ArrayList<>();
    private boolean hasMe;

    private Behaviour() {}

    /**
     * Reads a behaviour.
     *
     * @param title what its mistakes are told with
     * @param text the script
     * @return the behaviour
     * @throws BotException if it has mistakes, all of them in one message, each with its place
     */
    static Behaviour of(String title, String text) {
        Behaviour behaviour = new Behaviour();
        for (Statement statement : ScriptRun.read(text, List.of(), behaviour.mistakes)) {
            behaviour.attempt(statement);
            if (!isAdd(statement)) {
                behaviour.statements.add(statement);
            }
        }
        behaviour.mistakes.sort(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column));
        if (behaviour.mistakes.isEmpty() && behaviour.numbers.isEmpty() && !behaviour.hasMe) {
            behaviour.mistakes.add(new Mistake(1, 1, "no robot is told anything; write \"me\" or a number in front"));
        }
        if (!behaviour.mistakes.isEmpty()) {
            throw new BotException(String.join(
                    "\n",
                    behaviour.mistakes.stream()
                            .map(mistake -> mistake.in(title))
                            .toList()));
        }
        return behaviour;
    }

    private static boolean isAdd(Statement statement) {
        return statement instanceof Statement.ForSession line && line.command() instanceof SessionCommand.Add;
    }

    /** What is run, without the lines that add robots. */
    List<Statement> statements() {
        return statements;
    }

    /** Without {@code me} in it, the robot named first is the one it runs on. */
    List<Role> roles() {
        return roleByNumber().values().stream().distinct().toList();
    }

    /** The robots it means, among those it was given by role. */
    Selection among(Map<String, Member> given) {
        Map<Integer, Member> byNumber = new LinkedHashMap<>();
        roleByNumber().forEach((number, role) -> byNumber.put(number, given.get(role.name())));
        byNumber.remove(0);
        return new Selection(given.get(Role.ME), byNumber);
    }

    /** Under 0 stands {@code me}, where it is not one of the numbers. */
    private Map<Integer, Role> roleByNumber() {
        Map<Integer, Role> roles = new LinkedHashMap<>();
        if (hasMe) {
            roles.put(0, Role.any(Role.ME));
        }
        for (int number : numbers) {
            Role role = Role.any(roles.isEmpty() ? Role.ME : "robot" + number);
            roles.put(number, types.containsKey(number) ? role.types(types.get(number)) : role);
        }
        return roles;
    }

    /** Only the robots know which of their own commands are raw. */
    List<Mistake> rawCommands(Selection robots) {
        return own.stream()
                .filter(line ->
                        robots.present(line.robots()).stream().anyMatch(member -> isRaw(line.command(), member)))
                .map(line -> new ScriptException(
                                line.command().at(), line.command().at().text() + ": a behaviour gives no raw commands")
                        .mistake())
                .toList();
    }

    private static boolean isRaw(Command command, Member member) {
        return member.bot().commands().stream()
                .anyMatch(known -> known.raw()
                        && known.name().equalsIgnoreCase(command.at().text()));
    }

    private void attempt(Statement statement) {
        try {
            statement.accept(this);
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
        }
    }

    @Override
    public @Nullable Void repeat(Statement.Repeat repeat) {
        repeat.body().forEach(this::attempt);
        return null;
    }

    @Override
    public @Nullable Void whileLoop(Statement.While loop) {
        condition(loop.condition());
        loop.body().forEach(this::attempt);
        return null;
    }

    @Override
    public @Nullable Void choice(Statement.If choice) {
        condition(choice.condition());
        choice.body().forEach(this::attempt);
        choice.otherwise().forEach(this::attempt);
        return null;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        robots(line.robots());
        Command command = line.command();
        if (command instanceof Command.Act || command instanceof Command.ActOff) {
            throw new ScriptException(command.at(), "act: a behaviour does not run others");
        }
        if (command instanceof Command.Help) {
            throw new ScriptException(command.at(), "help: a behaviour needs none; leave the line out");
        }
        if (command instanceof Command.Move move) {
            condition(move.until());
        } else if (command instanceof Command.Turn turn) {
            condition(turn.until());
        } else if (command instanceof Command.Drive drive) {
            condition(drive.until());
        } else if (command instanceof Command.Own) {
            own.add(line);
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        SessionCommand command = line.command();
        if (command instanceof SessionCommand.Add add) {
            add(line, add);
        } else if (!(command instanceof SessionCommand.Await
                || command instanceof SessionCommand.Pause
                || command instanceof SessionCommand.StopAll)) {
            String word = line.at().text().toLowerCase(Locale.ROOT);
            throw new ScriptException(
                    line.at(), word + ": is for a session; a behaviour only commands the robots it is given");
        }
        return null;
    }

    private void add(Statement.ForSession line, SessionCommand.Add add) {
        if (add.number().isEmpty()) {
            throw new ScriptException(line.at(), "add: a behaviour is given its robots; leave the line out");
        }
        BotAddress address = BotAddress.parse(SessionCheck.text(add.address()));
        types.put(
                add.number().getAsInt(),
                address.scheme().equals(BotAddress.SIMULATED) ? address.rest() : address.scheme());
    }

    private void condition(@Nullable Condition condition) {
        if (condition != null) {
            condition.accept(new EachComparison(comparison -> {
                if (comparison.robots() != null) {
                    robots(comparison.robots());
                }
            }));
        }
    }

    private void robots(Robots robots) {
        for (Robots.Item item : robots.items()) {
            if (item instanceof Robots.One one) {
                numbers.add(one.number());
            } else if (item instanceof Robots.Me) {
                hasMe = true;
            } else if (item instanceof Robots.Span || item instanceof Robots.OfType) {
                throw new ScriptException(
                        item.at(), item.at().text() + ": a behaviour names its robots one by one: me, 2, 3 or all");
            }
        }
    }
}
