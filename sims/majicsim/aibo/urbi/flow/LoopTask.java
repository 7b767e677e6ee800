package majicsim.aibo.urbi.flow;

import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.SequenceTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.value.Failure;
import org.jspecify.annotations.Nullable;

/** A while loop. Each turn costs a cycle (URBI sheet, section 8), so no program can block the kernel. */
public final class LoopTask extends Task {
    private final Flow.While loop;
    private @Nullable Task turn;

    public LoopTask(Context context, Flow.While loop) {
        super(context);
        this.loop = loop;
    }

    @Override
    protected boolean advance() {
        if (turn == null) {
            if (!holds()) {
                return true;
            }
            turn = turn();
        }
        if (turn.step()) {
            turn = null;
        }
        return context.isLeft();
    }

    @Override
    public List<Task> parts() {
        return turn == null ? List.of() : List.of(turn);
    }

    private Task turn() {
        Task body = context.start(loop.body());
        return loop.step() == null ? body : new SequenceTask(context, body, context.start(loop.step()));
    }

    private boolean holds() {
        try {
            return loop.test().value(new Evaluator(context)).isTrue();
        } catch (Failure failure) {
            context.report(failure);
            return false;
        }
    }
}
