package majicsim.aibo.urbi.assign;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Modifier;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * What stands behind an assignment, with its values (URBI sheet, section 6). Immutable.
 *
 * @param numbers the values by the modifiers' names
 * @param phase the variable that {@code getphase} names, null without one
 */
record Modifiers(Map<String, Double> numbers, @Nullable Variable phase) {
    static final Modifiers NONE = new Modifiers(Map.of(), null);

    private static final String GET_PHASE = "getphase";
    private static final Set<String> KNOWN =
            Set.of("time", "speed", "accel", "smooth", "sin", "cos", "ampli", "phase", "adaptive", "timelimit");
    private static final Set<String> IN_UNITS = Set.of("speed", "accel", "ampli");

    /** The expressions whose values {@link #of} needs. */
    static List<Expr> expressions(List<Modifier> written) {
        return written.stream()
                .filter(modifier -> !modifier.name().equals(GET_PHASE))
                .map(Modifier::value)
                .toList();
    }

    /** @param values those of {@link #expressions}, in order */
    static Modifiers of(Context context, List<Modifier> written, List<Value> values) throws Failure {
        Map<String, Double> numbers = new HashMap<>();
        Variable phase = null;
        int next = 0;
        for (Modifier modifier : written) {
            if (modifier.name().equals(GET_PHASE)) {
                phase = variable(context, modifier);
            } else if (KNOWN.contains(modifier.name())) {
                numbers.put(modifier.name(), values.get(next++).number());
            } else {
                throw Failure.of("Unkown modificator name");
            }
        }
        return new Modifiers(Map.copyOf(numbers), phase);
    }

    /** Put into a string: each {@code $name} in it is replaced by the value of that name. */
    static String compose(String text, List<Modifier> written, List<Value> values) {
        String composed = text;
        for (int i = 0; i < Math.min(written.size(), values.size()); i++) {
            composed =
                    composed.replace("$" + written.get(i).name(), values.get(i).join());
        }
        return composed;
    }

    /** For a normalised assignment, where speeds and amplitudes are shares of the range. */
    Modifiers scaled(double range) {
        Map<String, Double> scaled = new HashMap<>(numbers);
        IN_UNITS.forEach(name -> scaled.computeIfPresent(name, (any, number) -> number * range));
        return new Modifiers(Map.copyOf(scaled), phase);
    }

    boolean has(String name) {
        return numbers.containsKey(name);
    }

    double get(String name, double otherwise) {
        return numbers.getOrDefault(name, otherwise);
    }

    boolean isEmpty() {
        return numbers.isEmpty() && phase == null;
    }

    /** Whether it never ends, and so needs no value to start from. */
    boolean oscillates() {
        return has("sin") || has("cos");
    }

    boolean isAdaptive() {
        return get("adaptive", 0) != 0 && (has("time") || has("speed"));
    }

    private static Variable variable(Context context, Modifier modifier) throws Failure {
        if (modifier.value() instanceof Expr.Variable named) {
            return new Evaluator(context).target(named.name(), true);
        }
        throw Failure.of("a variable is expected for the 'getphase' modificator");
    }
}
