package majic.ros.bridge;

import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BinaryNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import com.fasterxml.jackson.dataformat.cbor.CBORParser;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads CBOR as the server writes it: arrays of numbers are bytes with a tag for their type (rosbridge sheet 3; RFC
 * 8746, little-endian). Used by one thread.
 */
final class CborTree {
    private static final CBORFactory FACTORY = new CBORFactory();
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final CBORParser parser;

    private CborTree(CBORParser parser) {
        this.parser = parser;
    }

    /**
     * Reads one value.
     *
     * @throws IOException if the bytes do not begin with one
     */
    static JsonNode read(byte[] bytes) throws IOException {
        try (CBORParser parser = FACTORY.createParser(bytes)) {
            return new CborTree(parser).value(parser.nextToken());
        }
    }

    private JsonNode value(JsonToken token) throws IOException {
        if (token == null) {
            throw new IOException("the value is not complete");
        }
        return switch (token) {
            case START_OBJECT -> object();
            case START_ARRAY -> array();
            case VALUE_STRING -> TextNode.valueOf(parser.getText());
            case VALUE_NUMBER_INT -> integer();
            case VALUE_NUMBER_FLOAT -> NODES.numberNode(parser.getDoubleValue());
            case VALUE_TRUE -> BooleanNode.TRUE;
            case VALUE_FALSE -> BooleanNode.FALSE;
            case VALUE_EMBEDDED_OBJECT -> bytes(parser.getCurrentTag(), parser.getBinaryValue());
            case VALUE_NULL -> NODES.nullNode();
            default -> throw new IOException("not a value: " + token);
        };
    }

    private ObjectNode object() throws IOException {
        ObjectNode object = NODES.objectNode();
        for (JsonToken next = parser.nextToken(); next == JsonToken.FIELD_NAME; next = parser.nextToken()) {
            String name = parser.currentName();
            object.set(name, value(parser.nextToken()));
        }
        return object;
    }

    private ArrayNode array() throws IOException {
        ArrayNode array = NODES.arrayNode();
        for (JsonToken next = parser.nextToken(); next != JsonToken.END_ARRAY; next = parser.nextToken()) {
            array.add(value(next));
        }
        return array;
    }

    private JsonNode integer() throws IOException {
        return switch (parser.getNumberType()) {
            case INT -> NODES.numberNode(parser.getIntValue());
            case LONG -> NODES.numberNode(parser.getLongValue());
            default -> NODES.numberNode(parser.getBigIntegerValue());
        };
    }

    private static JsonNode bytes(int tag, byte[] bytes) {
        ByteBuffer from = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        return switch (tag) {
            case 69 -> numbers(from, Short.BYTES, to -> to.add(from.getShort() & 0xFFFF));
            case 70 -> numbers(from, Integer.BYTES, to -> to.add(from.getInt() & 0xFFFF_FFFFL));
            case 71 ->
                numbers(
                        from,
                        Long.BYTES,
                        to -> to.add(new java.math.BigInteger(Long.toUnsignedString(from.getLong()))));
            case 72 -> numbers(from, Byte.BYTES, to -> to.add((int) from.get()));
            case 77 -> numbers(from, Short.BYTES, to -> to.add((int) from.getShort()));
            case 78 -> numbers(from, Integer.BYTES, to -> to.add(from.getInt()));
            case 79 -> numbers(from, Long.BYTES, to -> to.add(from.getLong()));
            case 85 -> numbers(from, Float.BYTES, to -> to.add((double) from.getFloat()));
            case 86 -> numbers(from, Double.BYTES, to -> to.add(from.getDouble()));
            default -> BinaryNode.valueOf(bytes);
        };
    }

    /** Appends the next number. */
    private interface Next {
        void appendTo(ArrayNode to);
    }

    private static ArrayNode numbers(ByteBuffer from, int size, Next next) {
        ArrayNode numbers = NODES.arrayNode(from.remaining() / size);
        while (from.remaining() >= size) {
            next.appendTo(numbers);
        }
        return numbers;
    }
}
