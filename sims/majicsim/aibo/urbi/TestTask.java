package majicsim.aibo.urbi;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A test that is made anew each cycle; it never ends. A soft test counts only when it has held for its time. */
final class TestTask extends Task {
    private final Expr test;
    private @Nullable Evaluation evaluation;
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
        Evaluation due = evaluation == null ? new Evaluation(context, test, true) : evaluation;
        if (!due.step()) {
            evaluation = due;
            return false;
        }
        evaluation = null;
        boolean now = due.holds();
        if (!now) {
            trueSinceMs = Double.NaN;
        } else if (Double.isNaN(trueSinceMs)) {
            trueSinceMs = elapsedMs();
        }
        holds = now && elapsedMs() - trueSinceMs >= holdMs();
        return false;
    }

    @Override
    protected List<Task> parts() {
        return evaluation == null ? List.of() : List.of(evaluation);
    }

    private double holdMs() {
        if (!(test instanceof Expr.Soft soft)) {
            return 0;
        }
        Evaluation hold = new Evaluation(context, soft.holdMs(), true);
        hold.step();
        return hold.value() instanceof Value.Num ms ? ms.number() : 0;
    }
}
