package majicsim.aibo.urbi;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A while loop. Each turn costs a cycle (URBI sheet, section 8), so no program can hold the kernel up. */
final class LoopTask extends Task {
    private final Flow.While loop;
    private @Nullable Evaluation test;
    private @Nullable Task turn;

    LoopTask(Context context, Flow.While loop) {
        super(context);
        this.loop = loop;
    }

    @Override
    protected boolean advance() {
        if (turn == null) {
            Evaluation due = test == null ? new Evaluation(context, loop.test()) : test;
            test = due;
            if (!due.step()) {
                return false;
            }
            if (!due.holds()) {
                return true;
            }
            test = null;
            turn = loop.step() == null ? loop.body().start(context) : new ThenTask(context, loop.body(), loop.step());
        }
        if (turn.step()) {
            turn = null;
        }
        return context.isLeft();
    }

    @Override
    protected List<Task> parts() {
        List<Task> parts = new ArrayList<>();
        if (test != null) {
            parts.add(test);
        }
        if (turn != null) {
            parts.add(turn);
        }
        return parts;
    }
}
