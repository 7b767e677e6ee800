package majicsim.aibo.urbi.run;

import java.util.List;

/**
 * A running command. The kernel steps it once a cycle until it has ended; its time starts with its first step and stops
 * while it is frozen.
 */
public abstract class Task {
    /** The context in which it runs. */
    protected final Context context;

    private double startMs = Double.NaN;
    private double frozenAtMs = Double.NaN;
    private boolean over;

    /**
     * Creates a task.
     *
     * @param context in which it runs
     */
    protected Task(Context context) {
        this.context = context;
    }

    /**
     * Runs one step. Called once a cycle, and once when it starts.
     *
     * @return true when the command has ended by itself
     */
    protected abstract boolean advance();

    /**
     * The running parts of this command, which are frozen and ended with it.
     *
     * @return as they are now
     */
    public List<Task> parts() {
        return List.of();
    }

    /**
     * Whether the kernel has replaced this command by another, which has the messages from then on.
     *
     * @return true from the step on in which it was replaced
     */
    public boolean isReplaced() {
        return false;
    }

    /** Called once when it ends by itself or is ended; it must release its resources. */
    protected void ended() {}

    /**
     * Called when it is frozen or thawed.
     *
     * @param frozen true when it is frozen from now on
     */
    protected void halted(boolean frozen) {}

    /**
     * Gives it a tag, by which it is stopped and frozen.
     *
     * @param tag a word of the stick's own
     * @return the task to step in place of it
     */
    public final Task under(String tag) {
        return new TaggedTask(context.inner(tag), List.of(), this);
    }

    /** Steps it; returns true when it has ended for any reason. */
    public final boolean step() {
        if (over || isFrozen()) {
            return over;
        }
        if (Double.isNaN(startMs)) {
            startMs = context.nowMs();
        }
        if (advance() && !over) {
            finish();
        }
        return over;
    }

    public final void kill() {
        if (!over) {
            finish();
        }
    }

    /** Also ends the tasks inside it, because a function may return while they run. */
    private void finish() {
        over = true;
        List.copyOf(parts()).forEach(Task::kill);
        ended();
    }

    public final void freeze() {
        if (!over && !isFrozen()) {
            frozenAtMs = context.nowMs();
            parts().forEach(Task::freeze);
            halted(true);
        }
    }

    public final void thaw() {
        if (!over && isFrozen()) {
            startMs += context.nowMs() - frozenAtMs;
            frozenAtMs = Double.NaN;
            parts().forEach(Task::thaw);
            halted(false);
        }
    }

    public final boolean isOver() {
        return over;
    }

    public final boolean isFrozen() {
        return !Double.isNaN(frozenAtMs);
    }

    /**
     * The time of its first step, plus the time it was frozen.
     *
     * @return lab time, ms; not a number before
     */
    protected final double startMs() {
        return startMs;
    }

    /**
     * Its running time, without the time it was frozen.
     *
     * @return ms since its first step
     */
    protected final double elapsedMs() {
        return context.nowMs() - startMs;
    }

    /** Returns a command that ends at once and does nothing. */
    public static Task done(Context context) {
        return new Task(context) {
            @Override
            protected boolean advance() {
                return true;
            }
        };
    }
}
