package majicsim.aibo.urbi;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The properties of a variable, such as {@code x.val->rangemin} (URBI sheet, section 5). */
final class Properties {
    private static final Map<String, Double> DEFAULTS = Map.of(
            "rangemin",
            -Value.INFINITY,
            "rangemax",
            Value.INFINITY,
            "speedmin",
            0.0,
            "speedmax",
            Value.INFINITY,
            "delta",
            0.0);

    private final Map<String, Double> numbers = new HashMap<>(DEFAULTS);
    private Blend blend = Blend.NORMAL;
    private String unit = "";

    static Task assigning(Context context, Action.AssignProperty assignment) {
        return new Prepared(context, List.of(), values -> {
            Task all = Broadcast.of(context, assignment.target(), assignment::to);
            return all == null ? single(context, assignment) : all;
        });
    }

    private static Task single(Context context, Action.AssignProperty assignment) throws Failure {
        Variables variables = context.kernel().variables();
        String key = new Evaluator(context).key(assignment.target());
        Variable variable = variables.find(context, key);
        if (variable == null) {
            throw Failure.of("Variable " + variables.wantedName(context, key) + " does not exist");
        }
        String property = assignment.property();
        if (property.equals("blend") && assignment.value() instanceof Expr.Variable word) {
            variable.properties().write(property, blendMode(context, word.name()));
            return Task.done(context);
        }
        return new Prepared(context, List.of(assignment.value()), values -> {
            variable.properties().write(property, values.get(0));
            return null;
        });
    }

    Value read(String property) throws Failure {
        if (property.equals("blend")) {
            return Value.of(blend.word());
        }
        if (property.equals("unit")) {
            return Value.of(unit);
        }
        Double number = numbers.get(property);
        if (number == null) {
            throw Failure.inExpression("Unknown property: " + property);
        }
        return Value.of(number);
    }

    /** Becomes as another is. */
    void take(Properties other) {
        numbers.putAll(other.numbers);
        blend = other.blend;
        unit = other.unit;
    }

    void range(double min, double max) {
        numbers.put("rangemin", min);
        numbers.put("rangemax", max);
    }

    void blend(Blend mode) {
        blend = mode;
    }

    Blend blend() {
        return blend;
    }

    double clip(double value) {
        return Math.max(number("rangemin"), Math.min(number("rangemax"), value));
    }

    double range() {
        return number("rangemax") - number("rangemin");
    }

    double normalize(String name, double value) throws Failure {
        return (value - checkedMin(name)) / range();
    }

    double denormalize(String name, double value) throws Failure {
        return checkedMin(name) + value * range();
    }

    private double checkedMin(String name) throws Failure {
        if (number("rangemin") <= -Value.INFINITY || number("rangemax") >= Value.INFINITY) {
            throw Failure.of("Impossible to normalize: no range defined for variable " + name);
        }
        return number("rangemin");
    }

    /** One of the properties that are numbers. */
    double number(String property) {
        return Objects.requireNonNull(numbers.get(property), property);
    }

    private static Value blendMode(Context context, Name word) throws Failure {
        if (Blend.named(word.text()) == null) {
            String name = context.kernel().variables().wantedName(context, word.text());
            throw Failure.of("Unknown identifier: " + name, "Invalid blend mode.");
        }
        return Value.of(word.text());
    }

    private void write(String property, Value value) throws Failure {
        if (property.equals("blend")) {
            Blend mode = value instanceof Value.Text text ? Blend.named(text.text()) : null;
            if (mode == null) {
                throw Failure.of(
                        value instanceof Value.Text text
                                ? "Unknown blend mode: " + text.text()
                                : "Invalid blend mode.");
            }
            blend = mode;
        } else if (property.equals("unit")) {
            unit = value.join();
        } else if (!numbers.containsKey(property)) {
            throw Failure.of("Unknown property: " + property);
        } else if (value instanceof Value.Num num) {
            numbers.put(property, num.number());
        } else {
            throw Failure.of("Invalid " + property.replaceFirst("m(in|ax)$", "") + " type. NUM expected.");
        }
    }
}
