package majicsim.aibo;

import java.util.ArrayList;
import java.util.List;

/** An event handler: once for each time that its test becomes true, and again when it becomes false. */
final class AtTask extends Task {
    private static final int MAX_RUNS = 64;

    private final Statement.At handler;
    private final TestTask test;
    private final List<Task> runs = new ArrayList<>();
    private boolean inside;

    AtTask(Context context, Statement.At handler) {
        super(context);
        this.handler = handler;
        test = new TestTask(context, handler.test());
    }

    @Override
    protected boolean advance() {
        for (Task run : List.copyOf(runs)) {
            run.step();
        }
        runs.removeIf(Task::isOver);
        boolean now = test.holds();
        if (now != inside && !isOver()) {
            inside = now;
            launch(now);
        }
        return context.isLeft();
    }

    @Override
    protected List<Task> parts() {
        List<Task> parts = new ArrayList<>(runs);
        parts.add(test);
        return parts;
    }

    private void launch(boolean entered) {
        Statement body = entered ? handler.body() : handler.onLeave();
        if (body != null && runs.size() < MAX_RUNS) {
            Task run = body.start(context);
            runs.add(run);
            run.step();
        }
    }
}
