package majicsim.aibo.urbi.flow;

import java.util.IdentityHashMap;
import java.util.Map;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/**
 * A test that is made anew each cycle; it never ends. A soft test counts only when it has held for its time. An error
 * gives no message: it would come each cycle.
 */
final class TestTask extends Task {
    private final Expr test;
    private final Map<Expr.Variable, Value> fixed = new IdentityHashMap<>();
    private double trueSinceMs = Double.NaN;
    private boolean holds;

    TestTask(Context context, Expr test) {
        super(context);
        this.test = test;
    }

    /** Makes the test; the outcome stays until the next. */
    boolean holds() {
        step();
        return holds;
    }

    @Override
    protected boolean advance() {
        boolean now = value(test).isTrue();
        if (!now) {
            trueSinceMs = Double.NaN;
        } else if (Double.isNaN(trueSinceMs)) {
            trueSinceMs = elapsedMs();
        }
        holds = now && elapsedMs() - trueSinceMs >= holdMs();
        return false;
    }

    private Value value(Expr expr) {
        try {
            return expr.value(new Evaluator(context, fixed));
        } catch (Failure failure) {
            return Value.VOID;
        }
    }

    private double holdMs() {
        return test instanceof Expr.Soft soft && value(soft.holdMs()) instanceof Value.Num ms ? ms.number() : 0;
    }
}
