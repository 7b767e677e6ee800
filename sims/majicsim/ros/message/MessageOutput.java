package majicsim.ros.message;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.dataformat.cbor.CBORGenerator;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.stream.StreamSupport;

/**
 * Writes messages as the bridge of one version of ROS does (sheet 4): all fields in order, zero for missing ones,
 * {@code null} for NaN and infinity but in fixed arrays of ROS 2, base64 for bytes, float32 widened. CBOR keeps NaN and
 * infinity, and has bytes and typed arrays.
 */
public final class MessageOutput {
    private static final long NANOS_PER_SECOND = 1_000_000_000;

    private final MessageTypes types;

    /**
     * A writer.
     *
     * @param types all types
     */
    public MessageOutput(MessageTypes types) {
        this.types = types;
    }

    /**
     * Writes one message.
     *
     * @param to where to
     * @param type its type
     * @param message as {@link MessageInput} returns it; unknown fields are left out
     * @throws IOException if the output fails
     */
    public void write(JsonGenerator to, MessageType type, JsonNode message) throws IOException {
        to.writeStartObject();
        for (Field field : type.fields()) {
            to.writeFieldName(field.name());
            JsonNode value = message.path(field.name());
            boolean isDefault = value.isMissingNode() && field.initial() != 0;
            value(to, field.type(), isDefault ? DoubleNode.valueOf(field.initial()) : value);
        }
        to.writeEndObject();
    }

    /**
     * A copy of a message whose header has another number; ROS 1 counts the messages of a publisher.
     *
     * @param type its type
     * @param message as {@link MessageInput} returns it
     * @param number from 1
     * @return the same object if the type has no header or the version no numbers
     */
    public JsonNode numbered(MessageType type, ObjectNode message, long number) {
        if (types.version() != RosVersion.ROS1 || !type.hasHeader()) {
            return message;
        }
        String name = type.fields().get(0).name();
        ObjectNode header =
                message.path(name).isObject() ? ((ObjectNode) message.get(name)).deepCopy() : message.objectNode();
        ObjectNode numbered = message.objectNode();
        numbered.setAll(message);
        numbered.set(name, header.put("seq", number));
        return numbered;
    }

    /**
     * Whether the server can convert a message to CBOR. It takes the elements of arrays that it has no tag for as
     * messages, which fails for arrays of a fixed length, and on ROS 1 for texts and times.
     *
     * @param type its type
     * @param message as {@link MessageInput} returns it
     * @return false for a message that is not sent
     */
    public boolean hasCbor(MessageType type, JsonNode message) {
        return type.fields().stream().allMatch(field -> hasCbor(field.type(), message.path(field.name())));
    }

    private boolean hasCbor(FieldType type, JsonNode value) {
        if (type.isFixed()) {
            return false;
        }
        if (!type.isBuiltIn()) {
            MessageType part = types.get(type.element());
            return type.isArray()
                    ? StreamSupport.stream(value.spliterator(), false).allMatch(element -> hasCbor(part, element))
                    : hasCbor(part, value);
        }
        boolean isText = type.element().equals("string") && types.version() == RosVersion.ROS1;
        return !type.isArray() || value.isEmpty() || !isText && !type.element().equals("time");
    }

    private void value(JsonGenerator to, FieldType type, JsonNode value) throws IOException {
        if (type.isBytes()) {
            byte[] bytes = value.isBinary() ? value.binaryValue() : new byte[Math.max(0, type.length())];
            to.writeBinary(bytes);
        } else if (type.isArray() && to instanceof CBORGenerator binary && tag(type.element()) != 0) {
            typedArray(binary, type, value);
        } else if (type.isArray()) {
            int length = type.isFixed() ? type.length() : value.size();
            to.writeStartArray();
            for (int i = 0; i < length; i++) {
                scalar(to, type, value.path(i));
            }
            to.writeEndArray();
        } else {
            scalar(to, type, value);
        }
    }

    private void scalar(JsonGenerator to, FieldType type, JsonNode value) throws IOException {
        if (!type.isBuiltIn()) {
            write(to, types.get(type.element()), value.isObject() ? value : MissingNode.getInstance());
            return;
        }
        switch (type.element()) {
            case "bool" -> to.writeBoolean(value.asBoolean());
            case "string" -> to.writeString(value.asText());
            case "time" -> time(to, value.asLong());
            case "float32" -> number(to, type, (float) value.asDouble());
            case "float64" -> number(to, type, value.asDouble());
            default -> to.writeNumber(value.asLong());
        }
    }

    private void number(JsonGenerator to, FieldType type, double number) throws IOException {
        boolean isBare = types.version() == RosVersion.ROS2 && type.isFixed();
        if (Double.isFinite(number) || isBare || to instanceof CBORGenerator) {
            to.writeNumber(number);
        } else {
            to.writeNull();
        }
    }

    private void time(JsonGenerator to, long nanos) throws IOException {
        to.writeStartObject();
        to.writeNumberField(types.version().seconds(), Math.floorDiv(nanos, NANOS_PER_SECOND));
        to.writeNumberField(types.version().nanoseconds(), Math.floorMod(nanos, NANOS_PER_SECOND));
        to.writeEndObject();
    }

    /** An array of numbers: bytes in little-endian order behind a tag that gives their type (RFC 8746, section 2.1). */
    private static void typedArray(CBORGenerator to, FieldType type, JsonNode values) throws IOException {
        int length = values.size();
        ByteBuffer bytes = ByteBuffer.allocate(length * Double.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < length; i++) {
            put(bytes, type.element(), values.path(i));
        }
        to.writeTag(tag(type.element()));
        to.writeBinary(bytes.array(), 0, bytes.position());
    }

    /** The tag of arrays of these elements; 0 if there is none. */
    private static int tag(String element) {
        return switch (element) {
            case "uint16" -> 69;
            case "uint32" -> 70;
            case "uint64" -> 71;
            case "int8", "byte" -> 72;
            case "int16" -> 77;
            case "int32" -> 78;
            case "int64" -> 79;
            case "float32" -> 85;
            case "float64" -> 86;
            default -> 0;
        };
    }

    private static void put(ByteBuffer bytes, String element, JsonNode value) {
        switch (element) {
            case "int8", "byte" -> bytes.put((byte) value.asInt());
            case "int16", "uint16" -> bytes.putShort((short) value.asInt());
            case "int32", "uint32" -> bytes.putInt((int) value.asLong());
            case "int64", "uint64" -> bytes.putLong(value.asLong());
            case "float32" -> bytes.putFloat((float) value.asDouble());
            default -> bytes.putDouble(value.asDouble());
        }
    }
}
