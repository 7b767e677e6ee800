package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.ArrayList;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * Values in messages: a number in the unit of its parameter, true or false, a text, or a list of these;
 * {@code {"clear":true}} when nothing is in range, {@code {"unknown":"no reading yet"}} where there is no value, and
 * {@code {"about":12}} for an estimate.
 */
public final class ValueJson {
    private static final String CLEAR = "clear";
    private static final String UNKNOWN = "unknown";
    private static final String ABOUT = "about";

    private static final int DECIMALS = 6;
    private static final double STEPS = 1e6;
    private static final double FINE_STEPS = 1e7;

    private ValueJson() {}

    /**
     * Writes a value.
     *
     * @param value any
     * @return its JSON
     */
    public static JsonNode of(Value value) {
        JsonNodeFactory json = JsonNodeFactory.instance;
        if (value instanceof Value.Number number) {
            JsonNode amount = number(number.amount(), number.unit().digits());
            return number.about() ? json.objectNode().set(ABOUT, amount) : amount;
        }
        if (value instanceof Value.Flag flag) {
            return json.booleanNode(flag.yes());
        }
        if (value instanceof Value.Many many) {
            ArrayNode items = json.arrayNode();
            many.values().forEach(item -> items.add(of(item)));
            return items;
        }
        if (value instanceof Value.Clear) {
            return json.objectNode().put(CLEAR, true);
        }
        return value instanceof Value.Unknown unknown
                ? json.objectNode().put(UNKNOWN, unknown.reason())
                : json.textNode(value.toString());
    }

    /** With six decimals, more than any sensor has and half the bytes, or with the more digits of a latitude. */
    private static JsonNode number(double amount, int digits) {
        double steps = digits > DECIMALS ? FINE_STEPS : STEPS;
        double rounded = Math.rint(amount * steps) / steps;
        return rounded == Math.rint(rounded) && Math.abs(rounded) < 1e15
                ? JsonNodeFactory.instance.numberNode((long) rounded)
                : JsonNodeFactory.instance.numberNode(rounded);
    }

    /**
     * Reads the value of a parameter.
     *
     * @param json as {@link #of} writes it
     * @param parameter which one it is; its unit and words are those of the value
     * @return the value; what does not fit the parameter is shown as a text
     */
    public static Value read(JsonNode json, Parameter parameter) {
        if (json.isArray()) {
            List<Value> items = new ArrayList<>();
            json.forEach(item -> items.add(read(item, part(parameter, items.size()))));
            return Value.many(items);
        }
        if (json.isBoolean()) {
            return parameter.kind() == Parameter.Kind.ON_OFF
                    ? Value.onOff(json.booleanValue())
                    : Value.yesNo(json.booleanValue());
        }
        return json.isObject() ? readObject(json, parameter) : readScalar(json, parameter.unit(), false);
    }

    /** The description of a part of a list, which may have a unit of its own. */
    private static Parameter part(Parameter list, int index) {
        return index > 0 && index <= list.extras().size() ? list.extras().get(index - 1) : list;
    }

    private static Value readObject(JsonNode json, Parameter parameter) {
        if (json.path(CLEAR).asBoolean()) {
            return Value.CLEAR;
        }
        if (json.has(UNKNOWN)) {
            return Value.unknown(json.get(UNKNOWN).asText());
        }
        return json.has(ABOUT) ? readScalar(json.get(ABOUT), parameter.unit(), true) : Value.text(json.toString());
    }

    private static Value readScalar(JsonNode json, Unit unit, boolean about) {
        boolean isNumber = json.isNumber() && Double.isFinite(json.doubleValue());
        return isNumber ? new Value.Number(json.doubleValue(), unit, about) : Value.text(json.asText());
    }

    /**
     * Reads a value to set, before its parameter is known: a number has no unit.
     *
     * @param json a number, true or false, or a text
     * @return the value, for {@link Parameter#fit}
     * @throws UnusableMessageException if it is something else
     */
    public static Value given(JsonNode json) {
        if (json.isNumber() && Double.isFinite(json.doubleValue())) {
            return Value.of(json.doubleValue(), Unit.NONE);
        }
        if (json.isBoolean()) {
            return Value.yesNo(json.booleanValue());
        }
        if (json.isTextual()) {
            return Value.text(json.textValue());
        }
        throw new UnusableMessageException("request: a value is a number, true, false or a text");
    }
}
