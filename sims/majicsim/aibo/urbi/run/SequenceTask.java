package majicsim.aibo.urbi.run;

import java.util.List;

/** Two commands without a gap between them. */
public final class SequenceTask extends Task {
    private final Task first;
    private final Task second;

    public SequenceTask(Context context, Task first, Task second) {
        super(context);
        this.first = first;
        this.second = second;
    }

    @Override
    protected boolean advance() {
        if (!first.step()) {
            return false;
        }
        return context.isLeft() || (!isOver() && second.step());
    }

    @Override
    public List<Task> parts() {
        return List.of(first, second);
    }
}
