package majicsim.aibo.urbi.flow;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** A loop over the items of a list, one a cycle. */
public final class ForeachTask extends Task {
    private final Flow.Foreach loop;
    private final Deque<Value> items = new ArrayDeque<>();
    private @Nullable Task turn;

    public ForeachTask(Context context, Flow.Foreach loop, Value list) throws Failure {
        super(context);
        this.loop = loop;
        if (!(list instanceof Value.Items values)) {
            throw Failure.inExpression();
        }
        items.addAll(values.items());
    }

    @Override
    protected boolean advance() {
        if (turn == null) {
            Value item = items.poll();
            if (item == null) {
                return true;
            }
            if (!assign(item)) {
                return true;
            }
            turn = context.start(loop.body());
        }
        if (turn.step()) {
            turn = null;
        }
        return context.isLeft() || (turn == null && items.isEmpty());
    }

    private boolean assign(Value item) {
        try {
            context.variables().assign(context.scope(), loop.variable(), item);
            return true;
        } catch (Failure failure) {
            context.report(failure);
            return false;
        }
    }

    @Override
    public List<Task> parts() {
        return turn == null ? List.of() : List.of(turn);
    }
}
