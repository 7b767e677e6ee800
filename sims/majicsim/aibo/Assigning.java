package majicsim.aibo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The start of an assignment: its value, its modifiers and the variables it goes to (URBI sheet, sections 6 and 10). */
final class Assigning {
    private Assigning() {}

    static Task start(Context context, Action.Assign assignment) {
        List<Expr> exprs = new ArrayList<>(List.of(assignment.value()));
        assignment.modifiers().stream()
                .filter(modifier -> !modifier.name().equals("getphase"))
                .forEach(modifier -> exprs.add(modifier.value()));
        return new Prepared(context, exprs, values -> assign(context, assignment, values));
    }

    private static @Nullable Task assign(Context context, Action.Assign assignment, List<Value> values) throws Failure {
        Map<String, Double> modifiers = modifiers(assignment, values);
        Value value = values.get(0);
        if (assignment.declares() && context.frame() != null) {
            context.frame().declare(assignment.target().text(), value);
            return null;
        }
        List<Task> tasks = new ArrayList<>();
        Variables variables = context.kernel().variables();
        boolean make = assignment.declares() || !variables.isStrict();
        for (Variable variable : variables.targets(context, assignment.target(), make)) {
            if (!make) {
                checkType(variable, value);
            }
            if (value instanceof Value.Num num && !(variable.target() instanceof Value.Text)) {
                tasks.add(number(context, assignment, variable, num.number(), modifiers));
            } else if (variable.isDevice() && !(value instanceof Value.Binary)) {
                context.kernel().variables().replace(variable, value);
            } else {
                variable.write(value);
            }
        }
        return tasks.isEmpty() ? null : BothTask.of(context, tasks);
    }

    private static void checkType(Variable variable, Value value) throws Failure {
        Value old = variable.target();
        if (!(old instanceof Value.Void) && old.getClass() != value.getClass()) {
            throw Failure.of("Warning: " + variable.name() + " type mismatch");
        }
    }

    private static Map<String, Double> modifiers(Action.Assign assignment, List<Value> values) throws Failure {
        Map<String, Double> numbers = new HashMap<>();
        int next = 1;
        for (Modifier modifier : assignment.modifiers()) {
            Trajectory.check(modifier.name());
            if (!modifier.name().equals("getphase")) {
                numbers.put(modifier.name(), Operators.number(values.get(next++)));
            }
        }
        return numbers;
    }

    private static Task number(
            Context context, Action.Assign assignment, Variable variable, double value, Map<String, Double> modifiers)
            throws Failure {
        double target = assignment.target().suffix().equals("'n")
                ? variable.properties().denormalize(variable.name(), value)
                : value;
        if (modifiers.isEmpty()) {
            return new AssignTask(context, variable, target, Map.of());
        }
        if (!(variable.target() instanceof Value.Num)) {
            throw Failure.of("Modificator error: " + variable.name() + " unknown (no start value)");
        }
        return new AssignTask(context, variable, target, modifiers);
    }
}
