package majicsim.aibo.urbi.flow;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Statement;
import org.jspecify.annotations.Nullable;

/** Repeats a command as long as a test holds, and another as long as it does not; a turn a cycle. */
public final class WheneverTask extends Task {
    private final Flow.Whenever handler;
    private final TestTask test;
    private @Nullable Task run;

    public WheneverTask(Context context, Flow.Whenever handler) {
        super(context);
        this.handler = handler;
        test = new TestTask(context, handler.test());
    }

    @Override
    protected boolean advance() {
        boolean now = test.holds();
        if (run == null) {
            Statement body = now ? handler.body() : handler.otherwise();
            run = body == null ? null : context.start(body);
        }
        if (run != null && run.step()) {
            run = null;
        }
        return context.isLeft();
    }

    @Override
    public List<Task> parts() {
        List<Task> parts = new ArrayList<>(List.of(test));
        if (run != null) {
            parts.add(run);
        }
        return parts;
    }
}
