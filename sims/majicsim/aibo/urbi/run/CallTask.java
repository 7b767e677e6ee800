package majicsim.aibo.urbi.run;

import java.util.List;
import majicsim.aibo.urbi.memory.Frame;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** A call of a function whose body is commands; it ends with the body or with a return in it. */
public final class CallTask extends Task {
    /** The depth of nested commands, calls included, beyond which a call is refused: nested tasks need stack. */
    private static final int MAX_DEPTH = 300;

    private final Task body;
    private final Frame frame;

    private CallTask(Context context, Frame frame, Task body) {
        super(context);
        this.frame = frame;
        this.body = body;
    }

    public static CallTask of(Context context, Expr.Call call, Evaluator evaluator) throws Failure {
        Functions functions = context.functions();
        Frame frame = functions.frame(context, call.function());
        boolean allowed = context.server().budget().takeCall(context.server().pass());
        if (context.depth() > MAX_DEPTH || !allowed) {
            throw Failure.of("CPU Overload");
        }
        List<Value> arguments = evaluator.values(call.parts());
        Task body = functions.start(context, frame, call.function(), arguments);
        return new CallTask(context, frame, body);
    }

    public Value result() {
        return frame.result();
    }

    @Override
    protected boolean advance() {
        boolean ended = body.step();
        if (frame.hasReturned() && !ended) {
            body.kill();
            return true;
        }
        return ended;
    }

    @Override
    protected void ended() {
        context.variables().drop(frame);
    }

    @Override
    public List<Task> parts() {
        return List.of(body);
    }
}
