package majicsim.aibo.urbi.run;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** A command that first evaluates expressions, and then takes effect at once or continues as another task. */
public final class EvaluatingTask extends Task {
    /** The effect of a command with its values. */
    public interface Continuation {
        /** Takes effect; returns the task with which the command continues, or null if it is complete. */
        @Nullable
        Task with(List<Value> values) throws Failure;
    }

    private final List<Expr> exprs;
    private final boolean calls;
    private final Continuation continuation;
    private @Nullable CallTask call;
    private @Nullable Task rest;

    public EvaluatingTask(Context context, List<Expr> exprs, Continuation continuation) {
        this(context, exprs, false, continuation);
    }

    private EvaluatingTask(Context context, List<Expr> exprs, boolean calls, Continuation continuation) {
        super(context);
        this.exprs = exprs;
        this.calls = calls;
        this.continuation = continuation;
    }

    /**
     * A command whose first expression may be the call of a program's function, which runs first. Everywhere else in an
     * expression the kernel refuses such a call (URBI sheet, section 21).
     */
    public static EvaluatingTask calling(Context context, List<Expr> exprs, Continuation continuation) {
        return new EvaluatingTask(context, exprs, true, continuation);
    }

    @Override
    protected boolean advance() {
        if (rest != null) {
            return rest.step();
        }
        try {
            return mayGoOn() && goOn();
        } catch (Failure failure) {
            context.report(failure);
            return true;
        }
    }

    @Override
    public List<Task> parts() {
        List<Task> parts = new ArrayList<>();
        if (call != null) {
            parts.add(call);
        }
        if (rest != null) {
            parts.add(rest);
        }
        return parts;
    }

    @Override
    public boolean isReplaced() {
        return rest != null && rest.isReplaced();
    }

    /** Whether no function has to run first, or it has ended. */
    private boolean mayGoOn() throws Failure {
        if (call == null
                && calls
                && exprs.get(0) instanceof Expr.Call first
                && context.functions().takesTime(context, first.function())) {
            call = CallTask.of(context, first, new Evaluator(context));
        }
        return call == null || call.step();
    }

    private boolean goOn() throws Failure {
        if (isOver()) {
            return true;
        }
        Evaluator evaluator = new Evaluator(context);
        List<Value> values = new ArrayList<>();
        for (Expr expr : exprs) {
            values.add(call != null && values.isEmpty() ? call.result() : expr.value(evaluator));
        }
        Task next = continuation.with(values);
        rest = next;
        return next == null || next.step();
    }
}
