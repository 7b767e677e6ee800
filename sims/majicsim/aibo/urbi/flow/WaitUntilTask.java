package majicsim.aibo.urbi.flow;

import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Expr;

/** Waits until a test holds. */
public final class WaitUntilTask extends Task {
    private final TestTask test;

    public WaitUntilTask(Context context, Expr test) {
        super(context);
        this.test = new TestTask(context, test);
    }

    @Override
    protected boolean advance() {
        return test.holds();
    }

    @Override
    public List<Task> parts() {
        return List.of(test);
    }
}
