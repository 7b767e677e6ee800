package majicsim.aibo.urbi.flow;

import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Statement;
import org.jspecify.annotations.Nullable;

/** A loop of a known number of turns, or of endlessly many; each turn costs a cycle. */
public final class CountedLoop extends Task {
    private final Statement body;
    private double turnsLeft;
    private @Nullable Task turn;

    private CountedLoop(Context context, Statement body, double turns) {
        super(context);
        this.body = body;
        turnsLeft = turns;
    }

    public static Task start(Context context, Flow.Loop loop) {
        Expr times = loop.times();
        if (times == null) {
            return new CountedLoop(context, loop.body(), Double.POSITIVE_INFINITY);
        }
        return new EvaluatingTask(
                context,
                List.of(times),
                values -> new CountedLoop(context, loop.body(), values.get(0).number()));
    }

    @Override
    protected boolean advance() {
        if (turn == null) {
            if (turnsLeft < 1) {
                return true;
            }
            turn = context.start(body);
        }
        if (turn.step()) {
            turn = null;
            turnsLeft--;
        }
        return context.isLeft() || turnsLeft < 1;
    }

    @Override
    public List<Task> parts() {
        return turn == null ? List.of() : List.of(turn);
    }
}
