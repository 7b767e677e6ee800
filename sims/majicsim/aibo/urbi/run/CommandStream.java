package majicsim.aibo.urbi.run;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import majicsim.aibo.urbi.syntax.Flag;
import majicsim.aibo.urbi.syntax.SeparatedStatement;
import majicsim.aibo.urbi.syntax.Statement;
import org.jspecify.annotations.Nullable;

/**
 * A queue of commands (URBI sheet, section 3): after a command with a semicolon the next one waits for its end, after
 * one with a comma the next one starts at once. A block is a stream that ends; a connection's own stream never ends.
 */
public final class CommandStream extends Task {
    private final Deque<SeparatedStatement> pending = new ArrayDeque<>();
    private final List<Task> background = new ArrayList<>();
    private final boolean endless;
    private @Nullable Task foreground;

    /** A block. */
    public CommandStream(Context context, List<SeparatedStatement> steps) {
        super(context);
        endless = false;
        pending.addAll(steps);
    }

    /** The stream of a connection. */
    public CommandStream(Context context) {
        super(context);
        endless = true;
    }

    /** Adds a command; it starts at once if it need not wait. */
    public void add(SeparatedStatement step) {
        pending.add(step);
        if (foreground == null && !isFrozen()) {
            pump();
        }
    }

    /** Adds a task that runs in the background from the next cycle on. */
    public void adopt(Task task) {
        background.add(task);
    }

    public int waiting() {
        return pending.size() + background.size();
    }

    /** Ends everything in it, but not the stream itself. */
    public void clear() {
        pending.clear();
        List.copyOf(parts()).forEach(Task::kill);
    }

    @Override
    protected boolean advance() {
        for (Task task : List.copyOf(background)) {
            task.step();
        }
        background.removeIf(Task::isOver);
        if (!isOver()) {
            pump();
        }
        return !endless && (context.isLeft() || (pending.isEmpty() && foreground == null && background.isEmpty()));
    }

    @Override
    public List<Task> parts() {
        List<Task> parts = new ArrayList<>(background);
        if (foreground != null) {
            parts.add(foreground);
        }
        return parts;
    }

    private void pump() {
        while (!isOver() && !context.isLeft()) {
            if (foreground != null && !foreground.step()) {
                return;
            }
            foreground = null;
            SeparatedStatement next = pending.poll();
            if (next == null) {
                return;
            }
            begin(next);
        }
    }

    private void begin(SeparatedStatement step) {
        Task task = context.start(step.statement());
        if (!step.background() && !asksForBackground(step.statement())) {
            foreground = task;
            return;
        }
        background.add(task);
        if (task.step()) {
            background.remove(task);
        }
    }

    private static boolean asksForBackground(Statement statement) {
        return statement instanceof Statement.Tagged tagged && Flag.in(tagged.flags(), "bg");
    }
}
