package majicsim.aibo.urbi.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import majicsim.aibo.urbi.memory.Groups;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.TaggedTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.value.Value;

/** The long answers of the server: a line for each variable, group, function or command (URBI sheet, section 9). */
final class Listings {
    private Listings() {}

    static List<String> variables(Variables variables, boolean usersOnly) {
        return variables.all().stream()
                .filter(variable -> !usersOnly || !variables.isSystem(variable.name()))
                .map(variable -> variable.name() + " = " + brief(variable.read()))
                .toList();
    }

    static List<String> groups(Groups groups) {
        return groups.names().stream()
                .map(name -> name + " = {" + String.join(",", groups.members(name)) + "}")
                .toList();
    }

    static List<String> aliases(Map<String, String> aliases) {
        return aliases.entrySet().stream()
                .map(alias -> String.format(Locale.ROOT, "%25s -> %s", alias.getKey(), alias.getValue()))
                .toList();
    }

    /** The tags of what runs in a connection, outermost first. */
    static List<String> commands(Connection connection) {
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
