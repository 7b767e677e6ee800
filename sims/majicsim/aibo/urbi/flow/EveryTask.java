package majicsim.aibo.urbi.flow;

import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** Starts its body again and again, at the first cycle after each period; it never ends by itself. */
public final class EveryTask extends Task {
    private final Statement body;
    private final double periodMs;
    private final BodyRuns runs;
    private double lastMs = Double.NEGATIVE_INFINITY;

    public EveryTask(Context context, Statement body, Value period) throws Failure {
        super(context);
        this.body = body;
        periodMs = period.number();
        runs = new BodyRuns(context);
    }

    @Override
    protected boolean advance() {
        runs.step();
        double elapsedMs = elapsedMs();
        if (!isOver() && elapsedMs - lastMs >= periodMs) {
            lastMs = elapsedMs;
            runs.start(body);
        }
        return context.isLeft();
    }

    @Override
    public List<Task> parts() {
        return runs.parts();
    }

    @Override
    protected void ended() {
        runs.release();
    }
}
