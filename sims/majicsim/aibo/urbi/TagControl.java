package majicsim.aibo.urbi;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** {@code stop}, {@code freeze}, {@code block} and their opposites: they reach into all connections (URBI sheet, section 7). */
final class TagControl {
    private TagControl() {}

    static @Nullable Task apply(Context context, Action.Control control) throws Failure {
        String tag = control.tag();
        Kernel kernel = context.kernel();
        boolean refused = tag.equals(Parser.NO_TAG) && !control.word().equals("stop");
        if (refused) {
            throw Failure.of("cannot " + control.word() + " '" + tag + "'");
        }
        switch (control.word()) {
            case "stop" -> each(kernel, tag, Task::kill);
            case "freeze" -> {
                kernel.tags().freeze(tag);
                each(kernel, tag, Task::freeze);
            }
            case "unfreeze" -> {
                kernel.tags().unfreeze(tag);
                each(kernel, tag, Task::thaw);
            }
            case "block" -> kernel.tags().block(tag);
            default -> kernel.tags().unblock(tag);
        }
        return null;
    }

    private static void each(Kernel kernel, String tag, Consumer<Task> action) {
        List<Task> found = new ArrayList<>();
        for (Connection connection : kernel.connections()) {
            collect(connection.stream(), tag, found);
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
