package majicsim.aibo.urbi.command;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.run.TaggedTask;
import majicsim.aibo.urbi.run.Tags;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import org.jspecify.annotations.Nullable;

/**
 * {@code stop}, {@code freeze}, {@code block} and their opposites: they reach into all connections (URBI sheet, section
 * 7).
 */
final class TagControl {
    private TagControl() {}

    static @Nullable Task apply(Context context, Action.Control control) throws Failure {
        String tag = control.tag();
        Server server = context.server();
        boolean refused = tag.equals(Statement.NO_TAG) && !control.word().equals("stop");
        if (refused) {
            throw Failure.of("cannot " + control.word() + " '" + tag + "'");
        }
        switch (control.word()) {
            case "stop" -> each(server, tag, Task::kill);
            case "freeze" -> {
                server.tags().freeze(tag);
                each(server, tag, Task::freeze);
            }
            case "unfreeze" -> {
                server.tags().unfreeze(tag);
                each(server, tag, Task::thaw);
            }
            case "block" -> server.tags().block(tag);
            default -> server.tags().unblock(tag);
        }
        return null;
    }

    private static void each(Server server, String tag, Consumer<Task> action) {
        List<Task> found = new ArrayList<>();
        for (Connection connection : server.connections()) {
            collect(connection.commands(), tag, found);
        }
        found.forEach(action);
    }

    private static void collect(Task task, String tag, List<Task> found) {
        if (task instanceof TaggedTask tagged && !tagged.wasReplaced() && Tags.matches(tagged.tag(), tag)) {
            found.add(task);
        }
        for (Task part : task.parts()) {
            if (!part.isOver()) {
                collect(part, tag, found);
            }
        }
    }
}
