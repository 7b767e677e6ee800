package majicsim.aibo.urbi.command;

import java.util.List;
import majicsim.aibo.urbi.memory.Events;
import majicsim.aibo.urbi.memory.Memory;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Broadcast;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Substitute;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Flow;
import majicsim.aibo.urbi.syntax.Modifier;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** What the commands that take no time do; each gives the task that goes on, or null. */
final class Effects {
    private Effects() {}

    static @Nullable Task reply(Context context, Value value) {
        if (!(value instanceof Value.Void)) {
            context.reply(value);
        }
        return null;
    }

    static Task change(Context context, Action.Change change) throws Failure {
        Task all = Broadcast.of(
                context, change.target(), member -> new Action.Change(member, change.sign(), change.amount()));
        if (all != null) {
            return all;
        }
        String operator = change.sign() > 0 ? "+" : "-";
        Expr sum = new Expr.Binary(operator, new Expr.Variable(change.target()), change.amount());
        Statement assignment = new Action.Assign(change.target(), sum, List.of(), false);
        return Substitute.of(context, assignment);
    }

    static Task power(Context context, Action.Power power) throws Failure {
        Task all = Broadcast.of(context, power.device(), member -> new Action.Power(member, power.load()));
        if (all != null) {
            return all;
        }
        String load = new Evaluator(context).key(power.device()) + ".load";
        Variable now = context.variables().find(context.scope(), load);
        boolean opposite = now == null || !now.read().isTrue();
        Value wanted = power.load() == null ? Value.of(opposite) : Value.of(power.load());
        Statement assignment = new Action.Assign(Name.of(load), new Expr.Constant(wanted), List.of(), false);
        return Substitute.of(context, assignment);
    }

    static @Nullable Task choose(Context context, Flow.If choice, Value test) {
        Statement chosen = test.isTrue() ? choice.then() : choice.otherwise();
        return chosen == null ? null : context.start(chosen);
    }

    static @Nullable Task giveBack(Context context, List<Value> values) {
        if (context.frame() != null) {
            context.frame().giveBack(values.isEmpty() ? Value.VOID : values.get(0));
        }
        return null;
    }

    static @Nullable Task emit(Context context, Flow.Emit emit, List<Value> values) throws Failure {
        String key = new Evaluator(context).key(emit.event());
        boolean lasts = emit.durationMs() != null;
        double durationMs = lasts ? values.get(values.size() - 1).number() : 0;
        List<Value> arguments = values.subList(0, emit.arguments().size());
        Memory memory = context.memory();
        MemoryLimits.checkNames(memory.events().count());
        memory.events()
                .emit(
                        memory.variables().fullName(context.scope(), key),
                        new Events.Event(List.copyOf(arguments), durationMs));
        return null;
    }

    static @Nullable Task echo(Context context, Value value, List<Modifier> options) throws Failure {
        String recipients = "";
        for (Modifier option : options) {
            if (option.name().equals("connection")) {
                recipients = option.value().value(new Evaluator(context)).join();
            }
        }
        for (Connection connection : context.server().recipients(context.connection(), recipients)) {
            connection.send(context.tag(), "*** " + value.show());
        }
        return null;
    }
}
