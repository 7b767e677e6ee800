package majicsim.aibo.urbi.flow;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Statement;

/** An event handler: once for each time that its test becomes true, and again when it becomes false. */
public final class AtTask extends Task {
    private final Flow.At handler;
    private final TestTask test;
    private final BodyRuns runs;
    private boolean inside;

    public AtTask(Context context, Flow.At handler) {
        super(context);
        this.handler = handler;
        test = new TestTask(context, handler.test());
        runs = new BodyRuns(context);
    }

    @Override
    protected boolean advance() {
        runs.step();
        boolean now = test.holds();
        if (now != inside && !isOver()) {
            inside = now;
            Statement body = now ? handler.body() : handler.onLeave();
            if (body != null) {
                runs.start(body);
            }
        }
        return context.isLeft();
    }

    @Override
    public List<Task> parts() {
        List<Task> parts = new ArrayList<>(runs.parts());
        parts.add(test);
        return parts;
    }

    @Override
    protected void ended() {
        runs.release();
    }
}
