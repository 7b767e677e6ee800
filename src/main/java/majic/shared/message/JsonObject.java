package majic.shared.message;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Pattern;
import majic.bot.Pose;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * The fields of one message while it is read. Unknown fields are ignored, missing optional ones have their default, and
 * each error is a sentence that names the message and the field.
 */
final class JsonObject {
    /** Deeper than any message of this version; a description needs 7 levels. */
    private static final int DEEPEST = 20;

    /** Longer texts are cut: no message has a use for them, and they are shown to users. */
    private static final int LONGEST_TEXT = 4000;

    /** How much of a wrong field is repeated. */
    private static final int LONGEST_SHOWN = 60;

    /** Farther than a robot gets, mm. */
    private static final double FAR_MM = 1e9;

    /** A surrogate without its other half, which no message can contain in UTF-8. */
    private static final Pattern HALF_CHARACTER = Pattern.compile("\\p{Cs}");

    private static final JsonMapper JSON = JsonMapper.builder(JsonFactory.builder()
                    .streamReadConstraints(StreamReadConstraints.builder()
                            .maxNestingDepth(DEEPEST)
                            .build())
                    .build())
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private final String what;
    private final JsonNode fields;

    private JsonObject(String what, JsonNode fields) {
        this.what = what;
        this.fields = fields;
    }

    /**
     * Reads a message.
     *
     * @param what names it in errors: {@code request}
     * @param payload UTF-8
     * @param mostBytes a larger one is refused before it is read
     * @throws UnusableMessageException if it is larger, or not one JSON object
     */
    static JsonObject parse(String what, byte[] payload, int mostBytes) {
        if (payload.length > mostBytes) {
            throw new UnusableMessageException(
                    what + ": " + payload.length + " bytes are too many; at most " + mostBytes + " are read");
        }
        try {
            return of(what, JSON.readTree(payload));
        } catch (JsonProcessingException e) {
            throw new UnusableMessageException(what + ": is not JSON: " + reason(e));
        } catch (IOException e) {
            throw new UnusableMessageException(
                    what + ": is not JSON: " + VisibleText.of(String.valueOf(e.getMessage())));
        }
    }

    /** Without the place in the bytes, which are not shown. */
    private static String reason(JsonProcessingException problem) {
        return VisibleText.of(problem.getOriginalMessage()).replaceFirst(" \\(start marker.*", "");
    }

    static JsonObject of(String what, @Nullable JsonNode node) {
        if (node == null || !node.isObject()) {
            throw new UnusableMessageException(what + ": has to be a JSON object, as in {\"session\": \"…\"}");
        }
        return new JsonObject(what, node);
    }

    static ObjectNode create() {
        return JSON.createObjectNode();
    }

    static byte[] bytes(ObjectNode message) {
        try {
            return JSON.writeValueAsBytes(message);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("cannot be written as JSON: " + e.getOriginalMessage(), e);
        }
    }

    static void put(ObjectNode json, String field, Pose pose) {
        json.putObject(field).put("x", pose.xMm()).put("y", pose.yMm()).put("heading", pose.headingDeg());
    }

    boolean has(String field) {
        return fields.hasNonNull(field);
    }

    /** The field as it is; null if it is missing. */
    @Nullable
    JsonNode node(String field) {
        return has(field) ? fields.get(field) : null;
    }

    String text(String field) {
        return text(field, required(field, "a text"));
    }

    String text(String field, String otherwise) {
        return has(field) ? text(field) : otherwise;
    }

    private String text(String field, JsonNode node) {
        if (!node.isTextual()) {
            throw wrong(field, "it is a text");
        }
        return shortened(withoutHalfCharacters(node.textValue()), LONGEST_TEXT);
    }

    /** Most texts contain no surrogates, and the pattern takes much longer than the look for one. */
    private static String withoutHalfCharacters(String text) {
        for (int at = 0; at < text.length(); at++) {
            if (Character.isSurrogate(text.charAt(at))) {
                return HALF_CHARACTER.matcher(text).replaceAll("\uFFFD");
            }
        }
        return text;
    }

    double number(String field) {
        JsonNode node = required(field, "a number");
        if (!node.isNumber() || !Double.isFinite(node.doubleValue())) {
            throw wrong(field, "it is a number");
        }
        return node.doubleValue();
    }

    double number(String field, double otherwise) {
        return has(field) ? number(field) : otherwise;
    }

    long whole(String field) {
        JsonNode node = required(field, "a whole number");
        if (!node.isNumber() || !node.canConvertToLong() || node.doubleValue() != Math.rint(node.doubleValue())) {
            throw wrong(field, "it is a whole number");
        }
        return node.longValue();
    }

    long whole(String field, long otherwise) {
        return has(field) ? whole(field) : otherwise;
    }

    boolean flag(String field, boolean otherwise) {
        return has(field) ? flag(field) : otherwise;
    }

    boolean flag(String field) {
        JsonNode node = required(field, "true or false");
        if (!node.isBoolean()) {
            throw wrong(field, "it is true or false");
        }
        return node.booleanValue();
    }

    Pose pose(String field) {
        JsonObject numbers = object(field);
        Pose pose = new Pose(numbers.number("x"), numbers.number("y"), numbers.number("heading"));
        if (pose.distanceMm(Pose.START) > FAR_MM) {
            throw wrong(field, "it is less than 1000 km from its origin");
        }
        return pose;
    }

    JsonObject object(String field) {
        return of(what + ": " + field, required(field, "an object"));
    }

    /** The fields of an object, which need not be known; none if it is missing. */
    Map<String, JsonNode> fields(String field) {
        Map<String, JsonNode> all = new LinkedHashMap<>();
        if (has(field)) {
            object(field).fields.properties().forEach(one -> all.put(one.getKey(), one.getValue()));
        }
        return all;
    }

    /** The items of a list; none if the field is missing. */
    <T> List<T> list(String field, Function<JsonNode, T> reader) {
        List<T> items = new ArrayList<>();
        if (has(field)) {
            JsonNode node = fields.get(field);
            if (!node.isArray()) {
                throw wrong(field, "it is a list");
            }
            node.forEach(item -> items.add(reader.apply(item)));
        }
        return items;
    }

    List<String> texts(String field) {
        return list(field, item -> text(field, item));
    }

    List<JsonObject> objects(String field) {
        return list(field, item -> of(what + ": " + field, item));
    }

    UnusableMessageException wrong(String field, String right) {
        String shown = VisibleText.of(fields.path(field).toString());
        return new UnusableMessageException(
                what + ": \"" + field + "\" is " + shortened(shown, LONGEST_SHOWN) + "; " + right);
    }

    private static String shortened(String text, int most) {
        return text.length() > most ? VisibleText.beginning(text, most) + "…" : text;
    }

    private JsonNode required(String field, String kind) {
        if (!has(field)) {
            throw new UnusableMessageException(what + ": \"" + field + "\" is missing; it is " + kind);
        }
        return fields.get(field);
    }
}
