package majic.script;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import majic.bot.BotAddress;
import org.jspecify.annotations.Nullable;

/** Finds out which robots a behaviour means, and whether it says anything that only a session may say. */
final class BehaviourInspection extends Inspection {
    private final Map<Integer, String> types = new HashMap<>();
    private final Set<Integer> numbers = new LinkedHashSet<>();
    private final List<Statement.ForRobots> own = new ArrayList<>();
    private boolean hasMe;

    /** Whether it speaks of {@code me}. */
    boolean hasMe() {
        return hasMe;
    }

    /** The robots it names by number, in the order it does. */
    Set<Integer> numbers() {
        return numbers;
    }

    /** Of which type some of them are. */
    Map<Integer, String> types() {
        return types;
    }

    /** The lines with commands that only some types have. */
    List<Statement.ForRobots> own() {
        return own;
    }

    @Override
    void inspect(Condition condition) {
        condition.accept(new EachComparison(comparison -> {
            if (comparison.robots() != null) {
                robots(comparison.robots());
            }
        }));
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
        Condition until = until(command);
        if (until != null) {
            inspect(until);
        }
        if (command instanceof Command.Own) {
            own.add(line);
        }
        return null;
    }

    private static @Nullable Condition until(Command command) {
        if (command instanceof Command.Move move) {
            return move.until();
        }
        if (command instanceof Command.Turn turn) {
            return turn.until();
        }
        return command instanceof Command.Drive drive ? drive.until() : null;
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
        types.put(add.number().getAsInt(), type(address));
    }

    /** Where a lab has several robots of a type, they have numbers: {@code sim:pioneer2}. */
    private static String type(BotAddress address) {
        return address.scheme().equals(BotAddress.SIMULATED)
                ? address.rest().replaceFirst("\\d+$", "")
                : address.scheme();
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
