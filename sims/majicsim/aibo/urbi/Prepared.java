package majicsim.aibo.urbi;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command that needs some values first, and then has its effect at once or goes on as another task. */
final class Prepared extends Task {
    /** What to do with the values. */
    interface Continuation {
        /** Does it; returns what goes on then, or null if that was all. */
        @Nullable
        Task with(List<Value> values) throws Failure;
    }

    private final List<Evaluation> evaluations;
    private final Continuation continuation;
    private @Nullable Task rest;

    Prepared(Context context, List<Expr> exprs, Continuation continuation) {
        super(context);
        evaluations = exprs.stream().map(expr -> new Evaluation(context, expr)).toList();
        this.continuation = continuation;
    }

    @Override
    protected boolean advance() {
        if (rest != null) {
            return rest.step();
        }
        List<Value> values = new ArrayList<>();
        for (Evaluation evaluation : evaluations) {
            if (!evaluation.step()) {
                return false;
            }
            Value value = evaluation.value();
            if (value == null) {
                return true;
            }
            values.add(value);
        }
        return isOver() || goOn(values);
    }

    @Override
    protected List<Task> parts() {
        List<Task> parts = new ArrayList<>(evaluations);
        if (rest != null) {
            parts.add(rest);
        }
        return parts;
    }

    @Override
    boolean isReplaced() {
        return rest != null && rest.isReplaced();
    }

    private boolean goOn(List<Value> values) {
        try {
            Task next = continuation.with(values);
            rest = next;
            return next == null || next.step();
        } catch (Failure failure) {
            context.report(failure);
            return true;
        }
    }
}
