package majicsim.aibo.urbi.assign;

import java.util.List;
import majicsim.aibo.urbi.memory.Blend;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.run.Broadcast;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** {@code x->rangemin = v}: sets a property of a variable, or of all members of a group (URBI sheet, section 5). */
public final class PropertyAssignment {
    private PropertyAssignment() {}

    public static Task start(Context context, Action.AssignProperty assignment) {
        return new EvaluatingTask(context, List.of(), values -> {
            Task all = Broadcast.of(context, assignment.target(), assignment::to);
            return all == null ? single(context, assignment) : all;
        });
    }

    private static Task single(Context context, Action.AssignProperty assignment) throws Failure {
        Variables variables = context.variables();
        String key = new Evaluator(context).key(assignment.target());
        Variable variable = variables.find(context.scope(), key);
        if (variable == null) {
            throw Failure.of("Variable " + variables.wantedName(context.scope(), key) + " does not exist");
        }
        String property = assignment.property();
        if (property.equals("blend") && assignment.value() instanceof Expr.Variable word) {
            variable.properties().write(property, blendMode(context, word.name()));
            return Task.done(context);
        }
        return new EvaluatingTask(context, List.of(assignment.value()), values -> {
            variable.properties().write(property, values.get(0));
            return null;
        });
    }

    private static Value blendMode(Context context, Name word) throws Failure {
        if (Blend.named(word.text()) == null) {
            String name = context.variables().wantedName(context.scope(), word.text());
            throw Failure.of("Unknown identifier: " + name, "Invalid blend mode.");
        }
        return Value.of(word.text());
    }
}
