package majicsim.aibo.urbi.command;

import java.util.ArrayList;
import java.util.List;
import majicsim.aibo.urbi.assign.Assignments;
import majicsim.aibo.urbi.flow.AtTask;
import majicsim.aibo.urbi.flow.EveryTask;
import majicsim.aibo.urbi.flow.LoopTask;
import majicsim.aibo.urbi.flow.WaitUntilTask;
import majicsim.aibo.urbi.flow.WatchedTask;
import majicsim.aibo.urbi.flow.WheneverTask;
import majicsim.aibo.urbi.run.CommandStream;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.ParallelTask;
import majicsim.aibo.urbi.run.PauseTask;
import majicsim.aibo.urbi.run.SequenceTask;
import majicsim.aibo.urbi.run.TaggedTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Definition;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Flag;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Statement;

/** Makes the run of a command, one method for each kind (URBI sheet, sections 3 to 10). */
public final class TaskFactory implements Statement.Visitor<Task> {
    private final Context context;

    /** @param context of the runs that it makes */
    public TaskFactory(Context context) {
        this.context = context;
    }

    private Task doing(EvaluatingTask.Continuation effect) {
        return new EvaluatingTask(context, List.of(), effect);
    }

    private Task with(Expr expr, EvaluatingTask.Continuation effect) {
        return new EvaluatingTask(context, List.of(expr), effect);
    }

    @Override
    public Task empty(Statement.Empty command) {
        return Task.done(context);
    }

    @Override
    public Task tagged(Statement.Tagged command) {
        if (Flag.in(command.flags(), "connection")) {
            return Delegation.start(context.inner(command.tag()), command);
        }
        Context inner = context.inner(command.tag(), command.flags());
        return new TaggedTask(inner, command.flags(), inner.start(command.conditional()));
    }

    @Override
    public Task block(Statement.Block command) {
        return new CommandStream(context, command.steps());
    }

    @Override
    public Task both(Statement.Both command) {
        return new ParallelTask(context, context.start(command.left()), context.start(command.right()));
    }

    @Override
    public Task then(Statement.Then command) {
        return new SequenceTask(context, context.start(command.left()), context.start(command.right()));
    }

    @Override
    public Task evaluate(Action.Evaluate command) {
        return EvaluatingTask.calling(
                context, List.of(command.expr()), values -> Effects.reply(context, values.get(0)));
    }

    @Override
    public Task assign(Action.Assign command) {
        return Assignments.start(context, command);
    }

    @Override
    public Task change(Action.Change command) {
        return doing(values -> Effects.change(context, command));
    }

    @Override
    public Task assignProperty(Action.AssignProperty command) {
        return Assignments.start(context, command);
    }

    /** Does nothing: the command runs when its bytes are filled in. */
    @Override
    public Task assignBinary(Action.AssignBinary command) {
        return Task.done(context);
    }

    @Override
    public Task power(Action.Power command) {
        return doing(values -> Effects.power(context, command));
    }

    @Override
    public Task control(Action.Control command) {
        return doing(values -> TagControl.apply(context, command));
    }

    @Override
    public Task reach(Action.Reach command) {
        return doing(values -> SystemCommands.reach(context, command));
    }

    @Override
    public Task echo(Action.Echo command) {
        return with(command.value(), values -> Effects.echo(context, values.get(0), command.options()));
    }

    @Override
    public Task command(Action.Command command) {
        return doing(values -> SystemCommands.run(context, command.word()));
    }

    @Override
    public Task choose(Flow.If command) {
        return with(command.test(), values -> Effects.choose(context, command, values.get(0)));
    }

    @Override
    public Task repeatWhile(Flow.While command) {
        return LoopTask.of(context, command);
    }

    @Override
    public Task loop(Flow.Loop command) {
        return LoopTask.of(context, command);
    }

    @Override
    public Task foreach(Flow.Foreach command) {
        return with(command.list(), values -> LoopTask.of(context, command, values.get(0)));
    }

    @Override
    public Task every(Flow.Every command) {
        return with(command.periodMs(), values -> new EveryTask(context, command.body(), values.get(0)));
    }

    @Override
    public Task pause(Flow.Wait command) {
        return with(command.ms(), values -> PauseTask.of(context, values.get(0)));
    }

    @Override
    public Task waitUntil(Flow.WaitUntil command) {
        return new WaitUntilTask(context, command.test());
    }

    @Override
    public Task watch(Flow.Watched command) {
        return WatchedTask.start(context, command);
    }

    @Override
    public Task at(Flow.At command) {
        return new AtTask(context, command);
    }

    @Override
    public Task whenever(Flow.Whenever command) {
        return new WheneverTask(context, command);
    }

    @Override
    public Task giveBack(Flow.Return command) {
        List<Expr> value = command.value() == null ? List.of() : List.of(command.value());
        return new EvaluatingTask(context, value, values -> Effects.giveBack(context, values));
    }

    @Override
    public Task emit(Flow.Emit command) {
        List<Expr> exprs = new ArrayList<>(command.arguments());
        if (command.durationMs() != null) {
            exprs.add(command.durationMs());
        }
        return new EvaluatingTask(context, exprs, values -> Effects.emit(context, command, values));
    }

    @Override
    public Task declare(Definition.Declare command) {
        return doing(values -> Definitions.declare(context, command.target()));
    }

    @Override
    public Task define(Definition.Define command) {
        return doing(values -> Definitions.function(context, command));
    }

    @Override
    public Task undefine(Definition.Undefine command) {
        return doing(values -> Definitions.undefine(context, command.name()));
    }

    @Override
    public Task group(Definition.Grouping command) {
        return doing(values -> Definitions.group(context, command));
    }

    @Override
    public Task alias(Definition.Alias command) {
        return doing(values -> Definitions.alias(context, command));
    }

    @Override
    public Task event(Definition.Event command) {
        return doing(values -> Definitions.event(context, command));
    }

    @Override
    public Task classOf(Definition.ClassOf command) {
        return doing(values -> Definitions.classOf(context, command));
    }

    @Override
    public Task create(Definition.New command) {
        return new EvaluatingTask(context, command.arguments(), values -> Creation.start(context, command, values));
    }
}
