package majicsim.aibo.urbi.flow;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.SequenceTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** A loop of any kind. Each turn costs a cycle (URBI sheet, section 8), so no program can block the kernel. */
public final class LoopTask extends Task {
    private final Turns turns;
    private @Nullable Task turn;

    /** The turns of one kind of loop. */
    private interface Turns {
        /** Starts the next turn; null if there is none. */
        @Nullable
        Task next();

        /** Returns whether the loop ends together with the turn that has just ended. */
        default boolean areOver() {
            return false;
        }
    }

    private LoopTask(Context context, Turns turns) {
        super(context);
        this.turns = turns;
    }

    /** A while loop or a for loop. */
    public static Task of(Context context, Flow.While loop) {
        return new LoopTask(context, () -> holds(context, loop.test()) ? turn(context, loop) : null);
    }

    private static boolean holds(Context context, Expr test) {
        try {
            return test.value(new Evaluator(context)).isTrue();
        } catch (Failure failure) {
            context.report(failure);
            return false;
        }
    }

    private static Task turn(Context context, Flow.While loop) {
        Task body = context.start(loop.body());
        return loop.step() == null ? body : new SequenceTask(context, body, context.start(loop.step()));
    }

    /** A loop of a known number of turns, or of endlessly many. */
    public static Task of(Context context, Flow.Loop loop) {
        Expr times = loop.times();
        if (times == null) {
            return counted(context, loop, Double.POSITIVE_INFINITY);
        }
        return new EvaluatingTask(
                context,
                List.of(times),
                values -> counted(context, loop, values.get(0).number()));
    }

    private static Task counted(Context context, Flow.Loop loop, double times) {
        return new LoopTask(context, new Turns() {
            private double left = times;

            @Override
            public @Nullable Task next() {
                if (left < 1) {
                    return null;
                }
                left--;
                return context.start(loop.body());
            }

            @Override
            public boolean areOver() {
                return left < 1;
            }
        });
    }

    /**
     * A loop over the items of a list.
     *
     * @throws Failure if the value is no list
     */
    public static Task of(Context context, Flow.Foreach loop, Value list) throws Failure {
        if (!(list instanceof Value.Items values)) {
            throw Failure.inExpression();
        }
        Deque<Value> items = new ArrayDeque<>(values.items());
        return new LoopTask(context, new Turns() {
            @Override
            public @Nullable Task next() {
                Value item = items.poll();
                return item == null || !assign(context, loop.variable(), item) ? null : context.start(loop.body());
            }

            @Override
            public boolean areOver() {
                return items.isEmpty();
            }
        });
    }

    private static boolean assign(Context context, String variable, Value item) {
        try {
            context.variables().assign(context.scope(), variable, item);
            return true;
        } catch (Failure failure) {
            context.report(failure);
            return false;
        }
    }

    @Override
    protected boolean advance() {
        if (turn == null) {
            turn = turns.next();
            if (turn == null) {
                return true;
            }
        }
        if (turn.step()) {
            turn = null;
        }
        return context.isLeft() || turn == null && turns.areOver();
    }

    @Override
    public List<Task> parts() {
        return turn == null ? List.of() : List.of(turn);
    }
}
