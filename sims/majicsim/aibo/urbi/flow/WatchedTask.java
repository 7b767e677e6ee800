package majicsim.aibo.urbi.flow;

import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Statement;

/** A command under a condition: ended by {@code timeout} or {@code stopif}, held by {@code freezeif}. */
public final class WatchedTask extends Task {
    /** What is done to the command at this moment. */
    private enum Verdict {
        RUN,
        STOP,
        HOLD
    }

    /** Decides for the present moment. */
    private interface Watch {
        Verdict verdict(double elapsedMs);
    }

    private final Task body;
    private final Watch watch;
    private boolean holds;

    private WatchedTask(Context context, Statement body, Watch watch) {
        super(context);
        this.body = context.start(body);
        this.watch = watch;
    }

    public static Task start(Context context, Flow.Watched watched) {
        if (watched.word().equals("timeout")) {
            return new EvaluatingTask(context, List.of(watched.limit()), values -> {
                double limitMs = values.get(0).number();
                return new WatchedTask(
                        context, watched.body(), elapsedMs -> elapsedMs >= limitMs ? Verdict.STOP : Verdict.RUN);
            });
        }
        TestTask test = new TestTask(context, watched.limit());
        Verdict then = watched.word().equals("stopif") ? Verdict.STOP : Verdict.HOLD;
        return new WatchedTask(context, watched.body(), elapsedMs -> test.holds() ? then : Verdict.RUN);
    }

    @Override
    protected boolean advance() {
        switch (watch.verdict(elapsedMs())) {
            case STOP -> body.kill();
            case HOLD -> hold();
            case RUN -> release();
        }
        return body.step();
    }

    private void hold() {
        holds |= !body.isFrozen();
        body.freeze();
    }

    /** A command that was frozen by its tag stays frozen. */
    private void release() {
        if (holds) {
            holds = false;
            body.thaw();
        }
    }

    @Override
    public boolean isReplaced() {
        return body.isReplaced();
    }

    @Override
    public List<Task> parts() {
        return List.of(body);
    }
}
