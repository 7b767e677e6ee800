package majic.ros.parameters;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.BinaryNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import majic.bot.Unit;
import majic.bot.Value;
import majic.text.Suggestion;
import majic.text.VisibleText;

/** Reads single fields of any message, and lists them, in the units of the robot. */
final class MessageFields {
    private static final int MOST_FIELDS = 40;
    private static final int LONGEST_TEXT = 100;
    private static final int LONGEST_LIST = 6;

    /** The only field of the messages of std_msgs. */
    private static final String DATA = "data";

    private MessageFields() {}

    /**
     * Returns the value of a field.
     *
     * @param message any
     * @param path names, and indexes from 0, on the way to it; nothing for the field of a message that has only
     *     {@code data}
     * @return a number, a yes or no, or a text; unknown, with the fields that there are, if the path leads to none of
     *     these
     */
    static Value value(JsonNode message, List<String> path) {
        return read(message, path, MessageFields::value);
    }

    /**
     * Returns the value of a field for display: as {@link #value}, but a whole number has all its digits.
     *
     * @param path as in {@link #value}
     */
    static Value shown(JsonNode message, List<String> path) {
        return read(message, path, (node, place) -> isInexact(node) ? Value.text(node.asText()) : value(node, place));
    }

    private static Value read(JsonNode message, List<String> path, BiFunction<JsonNode, String, Value> reader) {
        JsonNode node = message;
        String place = "the message";
        List<String> whole = path.isEmpty() && message.has(DATA) ? List.of(DATA) : path;
        for (String name : whole) {
            JsonNode inner = inner(node, name);
            if (inner.isMissingNode()) {
                return Value.unknown(place + " has no " + name + content(node, name));
            }
            place = name;
            node = inner;
        }
        return reader.apply(node, place);
    }

    private static JsonNode inner(JsonNode node, String name) {
        if (node.isArray()) {
            return name.matches("\\d{1,9}") ? node.path(Integer.parseInt(name)) : node.path(-1);
        }
        if (node.has(name)) {
            return node.get(name);
        }
        return node.properties().stream()
                .filter(field -> field.getKey().equalsIgnoreCase(name))
                .findFirst()
                .map(Map.Entry::getValue)
                .orElseGet(() -> node.path(name));
    }

    private static Value value(JsonNode node, String place) {
        if (isInexact(node)) {
            return Value.about(node.doubleValue(), Unit.NONE);
        }
        if (node.isNumber()) {
            return Double.isFinite(node.doubleValue())
                    ? Value.of(node.doubleValue(), Unit.NONE)
                    : Value.unknown(place + " is not finite");
        }
        if (node.isBoolean()) {
            return Value.yesNo(node.booleanValue());
        }
        if (node.isTextual()) {
            return Value.text(shortened(node.asText()));
        }
        if (node.isBinary()) {
            return Value.text(bytes(node));
        }
        return Value.unknown(
                node.isNull() ? place + " is not finite" : "write a field behind " + place + content(node, ""));
    }

    /** Whether a node is a whole number that a double does not hold with all its digits. */
    private static boolean isInexact(JsonNode node) {
        return node.isIntegralNumber() && node.decimalValue().compareTo(new BigDecimal(node.doubleValue())) != 0;
    }

    private static String content(JsonNode node, String wanted) {
        if (node.isArray()) {
            return node.isEmpty() ? "; it is empty" : "; it has the numbers 0 to " + (node.size() - 1);
        }
        List<String> names = node.properties().stream().map(Map.Entry::getKey).toList();
        if (names.isEmpty()) {
            return "; it has no fields";
        }
        String suggestion = wanted.isEmpty() ? "" : Suggestion.didYouMean(wanted, names);
        return suggestion.isEmpty()
                ? "; it has " + names.stream().limit(MOST_FIELDS).collect(Collectors.joining(", "))
                : suggestion;
    }

    /**
     * Lists the fields of a message with their values.
     *
     * @return a line of {@code name: value} pairs with commas between them; long lists and texts are shortened
     */
    static String listed(JsonNode message) {
        List<String> fields = new ArrayList<>();
        list(message, "", fields);
        boolean more = fields.size() > MOST_FIELDS;
        return fields.isEmpty()
                ? "an empty message"
                : String.join(", ", more ? fields.subList(0, MOST_FIELDS) : fields) + (more ? " …" : "");
    }

    private static void list(JsonNode node, String name, List<String> fields) {
        if (fields.size() > MOST_FIELDS) {
            return;
        }
        if (node.isObject()) {
            node.properties()
                    .forEach(field -> list(
                            field.getValue(), name.isEmpty() ? field.getKey() : name + "/" + field.getKey(), fields));
        } else if (node.isArray() && node.size() > LONGEST_LIST) {
            fields.add(name + ": " + node.size() + " values");
        } else if (node.isArray() && node.path(0).isContainerNode()) {
            for (int index = 0; index < node.size(); index++) {
                list(node.get(index), name + "/" + index, fields);
            }
        } else if (node.isBinary()) {
            fields.add(name + ": " + bytes(node));
        } else {
            fields.add((name.isEmpty() ? "" : name + ": ")
                    + shortened(node.isTextual() ? node.asText() : node.toString()));
        }
    }

    private static String bytes(JsonNode node) {
        return ((BinaryNode) node).binaryValue().length + " bytes";
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST_TEXT ? text : VisibleText.beginning(text, LONGEST_TEXT) + "…";
    }
}
