package majicsim.aibo.urbi;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** An expression that is evaluated: first the functions in it that take time are called, innermost first. */
final class Evaluation extends Task {
    private final Expr expr;
    private final boolean quiet;
    private final Map<Expr.Call, Value> results = new IdentityHashMap<>();
    private @Nullable CallTask call;
    private @Nullable Value value;

    Evaluation(Context context, Expr expr) {
        this(context, expr, false);
    }

    /** With quiet, an error gives no message: a test of an event handler is tried again each cycle. */
    Evaluation(Context context, Expr expr, boolean quiet) {
        super(context);
        this.expr = expr;
        this.quiet = quiet;
    }

    /** The value once it has ended; null if it failed, which has been reported then. */
    @Nullable
    Value value() {
        return value;
    }

    /** Whether it is done and true. */
    boolean holds() {
        return value != null && value.isTrue();
    }

    @Override
    protected boolean advance() {
        try {
            return callAll() && evaluate();
        } catch (Failure failure) {
            if (!quiet) {
                context.report(failure);
            }
            return true;
        }
    }

    @Override
    protected List<Task> parts() {
        return call == null ? List.of() : List.of(call);
    }

    private boolean evaluate() throws Failure {
        value = expr.value(new Evaluator(context, results));
        return true;
    }

    private boolean callAll() throws Failure {
        while (!isOver()) {
            CallTask running = call;
            if (running == null) {
                Expr.Call open = openCall(expr);
                if (open == null) {
                    return true;
                }
                running = CallTask.of(context, open, new Evaluator(context, results));
                call = running;
            }
            if (!running.step()) {
                return false;
            }
            results.put(running.call(), running.result());
            call = null;
        }
        return false;
    }

    private Expr.@Nullable Call openCall(Expr tree) {
        for (Expr part : tree.parts()) {
            Expr.Call inner = openCall(part);
            if (inner != null) {
                return inner;
            }
        }
        if (tree instanceof Expr.Call found && !results.containsKey(found)) {
            return context.kernel().functions().takesTime(context, found.function()) ? found : null;
        }
        return null;
    }
}
