package majicsim.aibo.urbi.memory;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** The properties of a variable, such as {@code x.val->rangemin} (URBI sheet, section 5). */
public final class Properties {
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

    public Value read(String property) throws Failure {
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

    /** Copies all properties of another variable. */
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

    public Blend blend() {
        return blend;
    }

    public double clip(double value) {
        return Math.max(number("rangemin"), Math.min(number("rangemax"), value));
    }

    public double range() {
        return number("rangemax") - number("rangemin");
    }

    double normalize(String name, double value) throws Failure {
        return (value - checkedMin(name)) / range();
    }

    public double denormalize(String name, double value) throws Failure {
        return checkedMin(name) + value * range();
    }

    private double checkedMin(String name) throws Failure {
        if (number("rangemin") <= -Value.INFINITY || number("rangemax") >= Value.INFINITY) {
            throw Failure.of("Impossible to normalize: no range defined for variable " + name);
        }
        return number("rangemin");
    }

    /** One of the properties that are numbers. */
    public double number(String property) {
        return Objects.requireNonNull(numbers.get(property), property);
    }

    public void write(String property, Value value) throws Failure {
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
