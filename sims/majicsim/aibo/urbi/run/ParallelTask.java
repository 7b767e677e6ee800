package majicsim.aibo.urbi.run;

import java.util.List;

/** Two commands that start in the same cycle; it ends when both have ended. */
public final class ParallelTask extends Task {
    private final Task left;
    private final Task right;

    public ParallelTask(Context context, Task left, Task right) {
        super(context);
        this.left = left;
        this.right = right;
    }

    /** All of several; the list must not be empty. */
    static Task of(Context context, List<Task> tasks) {
        return tasks.stream()
                .reduce((left, right) -> new ParallelTask(context, left, right))
                .orElseGet(() -> Task.done(context));
    }

    @Override
    protected boolean advance() {
        boolean leftOver = left.step();
        return right.step() && leftOver;
    }

    @Override
    public List<Task> parts() {
        return List.of(left, right);
    }
}
