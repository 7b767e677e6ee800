package majicsim.aibo.urbi.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import majicsim.aibo.urbi.memory.Groups;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.PauseTask;
import majicsim.aibo.urbi.run.TaggedTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** The commands of one word, some of which list variables, groups, functions or commands (URBI sheet, section 9). */
final class SystemCommands {
    private SystemCommands() {}

    static @Nullable Task run(Context context, String word) {
        switch (word) {
            case "ping" -> context.info("pong time=" + (long) context.server().timestampMs());
            case "quit" -> context.connection().quit();
            case "connections" -> context.server().connections().forEach(each -> context.info(each.describe()));
            case "devices" -> context.info("devices is deprecated. Use 'group objects' instead.");
            case "motoron" -> renamed(context, "motor on");
            case "motoroff" -> renamed(context, "motor off");
            case "group" -> list(context, groups(context.memory().groups()));
            case "def" -> list(context, context.functions().listing());
            case "alias" -> list(context, aliases(context.variables().aliases()));
            case "vars", "uservars" -> list(context, variables(context.variables(), word.equals("uservars")));
            case "commands" -> list(context, commands(context.connection()));
            case "strict", "unstrict" -> context.variables().strict(word.equals("strict"));
            case "stopall" -> stopAll(context);
            case "reset" -> reset(context);
            case "noop" -> {
                return PauseTask.cycle(context);
            }
            default -> {
                // The other words, which would switch the robot off, have no reply here.
            }
        }
        return null;
    }

    private static void renamed(Context context, String today) {
        context.error("This command is no longer valid. Please use \"" + today + "\" instead");
    }

    private static void list(Context context, List<String> lines) {
        lines.forEach(context::info);
    }

    private static void reset(Context context) {
        context.info("Reset in progress");
        context.server().reset();
    }

    /** {@code disconnect} and {@code killall}: they close or clear another connection. */
    static @Nullable Task reach(Context context, Action.Reach reach) throws Failure {
        Connection other = context.server()
                .recipients(context.connection(), named(context, reach.connection()))
                .get(0);
        if (reach.word().equals("killall")) {
            other.clear();
        } else {
            other.quit();
        }
        return null;
    }

    /** The name of a connection as written, or the value of a shared variable of that name. */
    private static String named(Context context, String written) {
        Variable variable =
                written.indexOf('.') < 0 ? null : context.variables().find(context.scope(), written);
        return variable == null ? written : variable.read().join();
    }

    private static void stopAll(Context context) {
        context.server().connections().forEach(each -> each.clear());
        context.info("All commands cleared");
    }

    private static List<String> variables(Variables variables, boolean usersOnly) {
        return variables.all().stream()
                .filter(variable -> !usersOnly || !variables.isSystem(variable.name()))
                .map(variable -> variable.name() + " = " + brief(variable.read()))
                .toList();
    }

    private static List<String> groups(Groups groups) {
        return groups.names().stream()
                .map(name -> name + " = {" + String.join(",", groups.members(name)) + "}")
                .toList();
    }

    private static List<String> aliases(Map<String, String> aliases) {
        return aliases.entrySet().stream()
                .map(alias -> String.format(Locale.ROOT, "%25s -> %s", alias.getKey(), alias.getValue()))
                .toList();
    }

    /** The tags of what runs in a connection, outermost first. */
    private static List<String> commands(Connection connection) {
        List<String> lines = new ArrayList<>();
        collect(connection.commands(), "", lines);
        return lines;
    }

    private static void collect(Task task, String indent, List<String> lines) {
        String deeper = indent;
        if (task instanceof TaggedTask tagged && !tagged.wasReplaced()) {
            lines.add(indent + "Tag:[" + tagged.tag() + "]" + (task.isFrozen() ? " frozen" : ""));
            deeper = indent + " ";
        }
        for (Task part : List.copyOf(task.parts())) {
            if (!part.isOver()) {
                collect(part, deeper, lines);
            }
        }
    }

    private static String brief(Value value) {
        if (value instanceof Value.Binary binary) {
            return "BIN " + binary.bytes().length();
        }
        boolean plain = value instanceof Value.Num || value instanceof Value.Text;
        return plain ? value.join() : "UNKNOWN TYPE";
    }
}
