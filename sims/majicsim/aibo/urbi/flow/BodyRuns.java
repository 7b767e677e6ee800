package majicsim.aibo.urbi.flow;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Statement;

/**
 * The running executions of a body that a timer or an event handler started. They are counted in the whole server, so
 * that bodies that never end cannot use up its memory: above the limit none is started.
 */
final class BodyRuns {
    private final Context context;
    private final List<Task> running = new ArrayList<>();

    BodyRuns(Context context) {
        this.context = context;
    }

    void start(Statement body) {
        if (!context.server().budget().takeRun()) {
            return;
        }
        Task run = context.start(body);
        running.add(run);
        run.step();
    }

    void step() {
        for (Task run : List.copyOf(running)) {
            run.step();
        }
        for (Task run : List.copyOf(running)) {
            if (run.isOver()) {
                running.remove(run);
                context.server().budget().giveRunBack();
            }
        }
    }

    List<Task> parts() {
        return running;
    }

    /** To be called when their owner ends, after they were ended with it. */
    void release() {
        running.forEach(run -> context.server().budget().giveRunBack());
        running.clear();
    }
}
