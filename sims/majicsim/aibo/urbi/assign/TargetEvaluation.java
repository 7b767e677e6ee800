package majicsim.aibo.urbi.assign;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Properties;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/**
 * The present target of a running assignment. Each cycle evaluates its modifiers again, and the centre of an
 * oscillation, because a program may change an oscillation through the variables in these expressions (URBI sheet,
 * section 6).
 */
final class TargetEvaluation {
    private final Context context;
    private final Map<Expr.Variable, Value> fixed = new IdentityHashMap<>();
    private final Action.Assign assignment;
    private final Variable variable;
    private final boolean swings;
    private final boolean steady;
    private double value;
    private Target current;

    /**
     * The number that an assignment writes, with its modifiers. Immutable.
     *
     * @param value in the variable's own unit, not yet clipped
     * @param modifiers in the same unit
     */
    record Target(double value, Modifiers modifiers) {}

    /**
     * @param value what is assigned, as it was when the assignment started
     * @param modifiers as they were then
     */
    TargetEvaluation(Context context, Action.Assign assignment, Variable variable, double value, Modifiers modifiers)
            throws Failure {
        this.context = context;
        this.assignment = assignment;
        this.variable = variable;
        this.value = value;
        current = target(value, modifiers);
        swings = modifiers.oscillates();
        List<Expr> exprs = Modifiers.expressions(assignment.modifiers());
        steady = (!swings || assignment.value().isConstant()) && exprs.stream().allMatch(Expr::isConstant);
        renew(); // so that static variables keep the values of the start
    }

    Target current() {
        return current;
    }

    /**
     * Evaluates again; true if the target has changed. An expression that cannot be evaluated at once keeps its last
     * value.
     */
    boolean renew() {
        if (steady) {
            return false;
        }
        try {
            Target before = current;
            value = swings ? assignment.value().value(evaluator()).number() : value;
            current = target(value, modifiers());
            return !current.equals(before);
        } catch (Failure notNow) {
            return false;
        }
    }

    /** The target as it was written; a normalised one is converted to the variable's unit (URBI sheet, section 5). */
    private Target target(double written, Modifiers by) throws Failure {
        if (!assignment.target().suffix().equals("'n")) {
            return new Target(written, by);
        }
        Properties properties = variable.properties();
        double target = properties.denormalize(variable.name(), Math.max(0, Math.min(1, written)));
        return new Target(target, by.scaled(properties.range()));
    }

    private Modifiers modifiers() throws Failure {
        List<Value> values = evaluator().values(Modifiers.expressions(assignment.modifiers()));
        return Modifiers.of(context, assignment.modifiers(), values);
    }

    private Evaluator evaluator() {
        return new Evaluator(context, fixed);
    }
}
