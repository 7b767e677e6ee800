package majicsim.aibo.urbi.assign;

import java.util.ArrayList;
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
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * Starts assignments to variables and to their properties: evaluates values and modifiers, and finds the variables
 * (URBI sheet, sections 5, 6 and 10).
 */
public final class Assignments {
    private Assignments() {}

    /** {@code x = v}: writes a variable, or all members of a group. */
    public static Task start(Context context, Action.Assign assignment) {
        return new EvaluatingTask(context, List.of(), values -> {
            Task all = isLocal(context, assignment) ? null : Broadcast.of(context, assignment.target(), assignment::to);
            return all == null ? single(context, assignment) : all;
        });
    }

    private static Task single(Context context, Action.Assign assignment) {
        List<Expr> exprs = new ArrayList<>(List.of(assignment.value()));
        exprs.addAll(Modifiers.expressions(assignment.modifiers()));
        return EvaluatingTask.calling(context, exprs, values -> assign(context, assignment, values));
    }

    private static boolean isLocal(Context context, Action.Assign assignment) {
        return assignment.declares() && context.frame() != null;
    }

    private static @Nullable Task assign(Context context, Action.Assign assignment, List<Value> values) throws Failure {
        List<Value> rest = values.subList(1, values.size());
        Value value = values.get(0);
        Modifiers modifiers = Modifiers.NONE;
        if (value instanceof Value.Text text) {
            value = MemoryLimits.checked(Value.of(Modifiers.compose(text.text(), assignment.modifiers(), rest)));
        } else {
            modifiers = Modifiers.of(context, assignment.modifiers(), rest);
        }
        context.variables().admit(value, context.server().pass());
        if (isLocal(context, assignment)) {
            context.variables().declare(context.scope(), assignment.target().text(), value);
            return null;
        }
        return write(context, assignment, value, modifiers);
    }

    private static @Nullable Task write(Context context, Action.Assign assignment, Value value, Modifiers modifiers)
            throws Failure {
        Variables variables = context.variables();
        boolean make = assignment.declares() || !variables.isStrict();
        Variable variable = new Evaluator(context).target(assignment.target(), make);
        if (!make) {
            checkType(variable, value);
        }
        if (value instanceof Value.Num num && !(variable.target() instanceof Value.Text)) {
            return number(context, assignment, variable, num.number(), modifiers);
        }
        if (variable.isDevice() && !(value instanceof Value.Binary)) {
            variables.replace(variable, value);
        } else {
            variable.write(value);
        }
        return null;
    }

    private static void checkType(Variable variable, Value value) throws Failure {
        Value old = variable.target();
        if (!(old instanceof Value.Void) && old.getClass() != value.getClass()) {
            throw Failure.of("Warning: " + variable.name() + " type mismatch");
        }
    }

    private static Task number(
            Context context, Action.Assign assignment, Variable variable, double value, Modifiers modifiers)
            throws Failure {
        boolean hasStart = variable.target() instanceof Value.Num;
        if (!modifiers.isEmpty() && !modifiers.oscillates() && !hasStart) {
            throw Failure.of("Modificator error: " + variable.name() + " unknown (no start value)");
        }
        return new AssignTask(context, variable, new TargetEvaluation(context, assignment, variable, value, modifiers));
    }

    /** {@code x->rangemin = v}: sets a property of a variable, or of all members of a group (URBI sheet, section 5). */
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
