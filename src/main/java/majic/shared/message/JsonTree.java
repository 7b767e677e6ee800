package majic.shared.message;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParseException;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes JSON as a tree. An object mapper does the same with more code, which delays a command: between two
 * commands, other programs replace that code in the caches of the processor.
 */
final class JsonTree {
    /** Deeper than any message of this version; a description needs 7 levels. */
    private static final int DEEPEST = 20;

    private static final int USUAL_BYTES = 300;

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            .build();

    private JsonTree() {}

    /**
     * Reads one value.
     *
     * @param json UTF-8
     * @return null if there is none
     * @throws IOException if it is not JSON, or something follows it
     */
    static @Nullable JsonNode read(byte[] json) throws IOException {
        try (JsonParser parser = JSON.createParser(json)) {
            JsonToken first = parser.nextToken();
            JsonNode value = first == null ? null : value(parser, first);
            if (parser.nextToken() != null) {
                throw new JsonParseException(parser, "something follows the end of the message");
            }
            return value;
        }
    }

    private static JsonNode value(JsonParser from, JsonToken token) throws IOException {
        return switch (token) {
            case START_OBJECT -> object(from);
            case START_ARRAY -> array(from);
            case VALUE_STRING -> NODES.textNode(from.getText());
            case VALUE_NUMBER_INT -> whole(from);
            case VALUE_NUMBER_FLOAT -> NODES.numberNode(from.getDoubleValue());
            case VALUE_TRUE -> NODES.booleanNode(true);
            case VALUE_FALSE -> NODES.booleanNode(false);
            case VALUE_NULL -> NODES.nullNode();
            case NOT_AVAILABLE, END_OBJECT, END_ARRAY, FIELD_NAME, VALUE_EMBEDDED_OBJECT ->
                throw new JsonParseException(from, "a value is missing");
        };
    }

    private static ObjectNode object(JsonParser from) throws IOException {
        ObjectNode object = NODES.objectNode();
        for (String name = from.nextFieldName(); name != null; name = from.nextFieldName()) {
            object.set(name, value(from, from.nextToken()));
        }
        return object;
    }

    private static ArrayNode array(JsonParser from) throws IOException {
        ArrayNode array = NODES.arrayNode();
        for (JsonToken next = from.nextToken(); next != JsonToken.END_ARRAY; next = from.nextToken()) {
            array.add(value(from, next));
        }
        return array;
    }

    private static JsonNode whole(JsonParser from) throws IOException {
        return switch (from.getNumberType()) {
            case INT -> NODES.numberNode(from.getIntValue());
            case LONG -> NODES.numberNode(from.getLongValue());
            case BIG_INTEGER, FLOAT, DOUBLE, BIG_DECIMAL -> NODES.numberNode(from.getBigIntegerValue());
        };
    }

    static ObjectNode object() {
        return NODES.objectNode();
    }

    /** Writes a tree as UTF-8. */
    static byte[] write(JsonNode tree) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(USUAL_BYTES);
        try (JsonGenerator to = JSON.createGenerator(bytes)) {
            write(tree, to);
        }
        return bytes.toByteArray();
    }

    private static void write(JsonNode value, JsonGenerator to) throws IOException {
        switch (value.getNodeType()) {
            case OBJECT -> writeFields(value, to);
            case ARRAY -> writeItems(value, to);
            case STRING -> to.writeString(value.textValue());
            case NUMBER -> writeNumber(value, to);
            case BOOLEAN -> to.writeBoolean(value.booleanValue());
            case NULL, MISSING, BINARY, POJO -> to.writeNull();
        }
    }

    private static void writeFields(JsonNode object, JsonGenerator to) throws IOException {
        to.writeStartObject();
        for (Map.Entry<String, JsonNode> field : object.properties()) {
            to.writeFieldName(field.getKey());
            write(field.getValue(), to);
        }
        to.writeEndObject();
    }

    private static void writeItems(JsonNode array, JsonGenerator to) throws IOException {
        to.writeStartArray();
        for (JsonNode item : array) {
            write(item, to);
        }
        to.writeEndArray();
    }

    private static void writeNumber(JsonNode number, JsonGenerator to) throws IOException {
        if (number.isBigDecimal() || number.isBigInteger()) {
            to.writeNumber(number.decimalValue());
        } else if (number.isIntegralNumber()) {
            to.writeNumber(number.longValue());
        } else {
            to.writeNumber(number.doubleValue());
        }
    }
}
