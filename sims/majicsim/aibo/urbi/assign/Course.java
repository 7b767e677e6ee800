package majicsim.aibo.urbi.assign;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.syntax.Action;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/**
 * The present aim of a running assignment. Its modifiers are evaluated again each cycle, and so is the centre of an oscillation: a
 * program steers a swing through the variables in it (URBI sheet, section 6).
 */
final class Course {
    private final Context context;
    private final Map<Expr.Variable, Value> fixed = new IdentityHashMap<>();
    private final Action.Assign assignment;
    private final Variable variable;
    private final boolean swings;
    private final boolean steady;
    private double value;
    private Aim aim;

    /**
     * @param value what is assigned, as it was when the assignment started
     * @param modifiers as they were then
     */
    Course(Context context, Action.Assign assignment, Variable variable, double value, Modifiers modifiers)
            throws Failure {
        this.context = context;
        this.assignment = assignment;
        this.variable = variable;
        this.value = value;
        aim = Aim.of(assignment, variable, value, modifiers);
        swings = modifiers.oscillates();
        List<Expr> exprs = Modifiers.expressions(assignment.modifiers());
        steady = (!swings || assignment.value().isConstant()) && exprs.stream().allMatch(Expr::isConstant);
        renew(); // so that static variables keep the values of the start
    }

    Aim aim() {
        return aim;
    }

    /** Evaluates again; true if the aim has changed. What cannot be evaluated at once stays as it was. */
    boolean renew() {
        if (steady) {
            return false;
        }
        try {
            Aim before = aim;
            value = swings ? assignment.value().value(evaluator()).number() : value;
            aim = Aim.of(assignment, variable, value, modifiers());
            return !aim.equals(before);
        } catch (Failure notNow) {
            return false;
        }
    }

    private Modifiers modifiers() throws Failure {
        List<Value> values = evaluator().values(Modifiers.expressions(assignment.modifiers()));
        return Modifiers.of(context, assignment.modifiers(), values);
    }

    private Evaluator evaluator() {
        return new Evaluator(context, fixed);
    }
}
