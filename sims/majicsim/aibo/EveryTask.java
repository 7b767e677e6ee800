package majicsim.aibo;

import java.util.ArrayList;
import java.util.List;

/** Starts its body again and again, at the first cycle after each period; it never ends by itself. */
final class EveryTask extends Task {
    /** More runs than this beside each other are not started, so that a body that never ends cannot eat the memory. */
    private static final int MAX_RUNS = 64;

    private final Statement body;
    private final double periodMs;
    private final List<Task> runs = new ArrayList<>();
    private double lastMs = Double.NEGATIVE_INFINITY;

    EveryTask(Context context, Statement body, Value period) throws Failure {
        super(context);
        this.body = body;
        periodMs = Operators.number(period);
    }

    @Override
    protected boolean advance() {
        for (Task run : List.copyOf(runs)) {
            run.step();
        }
        runs.removeIf(Task::isOver);
        double elapsedMs = elapsedMs();
        if (!isOver() && elapsedMs - lastMs >= periodMs && runs.size() < MAX_RUNS) {
            lastMs = elapsedMs;
            Task run = body.start(context);
            runs.add(run);
            run.step();
        }
        return context.isLeft();
    }

    @Override
    protected List<Task> parts() {
        return runs;
    }
}
