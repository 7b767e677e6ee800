package majicsim.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BinaryNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.Base64;
import java.util.Map;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Checks received objects against their types (sheet 3 and 4). The result has the received fields alone; a missing one
 * means zero. A time is a number of ns since 1970, a byte array is binary, a float32 has been rounded to one.
 */
public final class MessageInput {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final long NANOS_PER_SECOND = 1_000_000_000;

    private final MessageTypes types;
    private final LongSupplier now;

    /**
     * A checker.
     *
     * @param types all types
     * @param now the robot's clock, ns since 1970
     */
    public MessageInput(MessageTypes types, LongSupplier now) {
        this.types = types;
        this.now = now;
    }

    /**
     * Checks one object.
     *
     * @param type what it must be
     * @param received as parsed; may hold NaN and infinite numbers
     * @return the checked object
     * @throws MessageMismatch if a field is unknown or has another type; the message is that of the bridge
     */
    public ObjectNode checked(MessageType type, JsonNode received) throws MessageMismatch {
        if (!received.isObject()) {
            throw new MessageMismatch("Message type " + type.fullName() + " expects an object");
        }
        ObjectNode checked = NODES.objectNode();
        for (Map.Entry<String, JsonNode> entry : received.properties()) {
            Field field = type.field(entry.getKey());
            if (field == null) {
                throw new MessageMismatch(
                        "Message type " + type.fullName() + " does not have a field " + entry.getKey());
            }
            checked.set(field.name(), value(field.type(), entry.getValue()));
        }
        if (type.isHeader() && isWithoutTime(received.get("stamp"))) {
            checked.put("stamp", now.getAsLong());
        }
        return checked;
    }

    /** By ROS 1 a stamp with the names of ROS 2 counts as none. */
    private boolean isWithoutTime(@Nullable JsonNode stamp) {
        return stamp == null || (stamp.isObject() && !hasTime(stamp, types.version()) && !hasOtherTime(stamp));
    }

    private boolean hasOtherTime(JsonNode stamp) {
        return types.version() == RosVersion.ROS2 && hasTime(stamp, RosVersion.ROS1);
    }

    private static boolean hasTime(JsonNode stamp, RosVersion version) {
        return stamp.has(version.seconds()) || stamp.has(version.nanoseconds());
    }

    private JsonNode value(FieldType type, JsonNode received) throws MessageMismatch {
        if (type.isBytes()) {
            return bytes(type, received);
        }
        return type.isArray() ? array(type, received) : scalar(type, received);
    }

    private JsonNode array(FieldType type, JsonNode received) throws MessageMismatch {
        if (!received.isArray() || (type.isFixed() && received.size() != type.length())) {
            throw mismatch(type, received);
        }
        ArrayNode array = NODES.arrayNode(received.size());
        for (JsonNode element : received) {
            array.add(scalar(type.ofElement(), element));
        }
        return array;
    }

    private static JsonNode bytes(FieldType type, JsonNode received) throws MessageMismatch {
        byte[] bytes = received.isTextual() ? base64(type, received) : numbers(type, received);
        if (type.isFixed() && bytes.length != type.length()) {
            throw mismatch(type, received);
        }
        return BinaryNode.valueOf(bytes);
    }

    /** Characters that are not of the alphabet are left out, as Python does. */
    private static byte[] base64(FieldType type, JsonNode received) throws MessageMismatch {
        try {
            return Base64.getMimeDecoder().decode(received.textValue());
        } catch (IllegalArgumentException e) {
            throw mismatch(type, received);
        }
    }

    private static byte[] numbers(FieldType type, JsonNode received) throws MessageMismatch {
        byte[] bytes = new byte[received.size()];
        for (int i = 0; i < bytes.length; i++) {
            JsonNode number = received.path(i);
            if (!received.isArray() || !number.isIntegralNumber() || number.intValue() >> 8 != 0) {
                throw mismatch(type, received);
            }
            bytes[i] = (byte) number.intValue();
        }
        if (!received.isArray()) {
            throw mismatch(type, received);
        }
        return bytes;
    }

    private JsonNode scalar(FieldType type, JsonNode received) throws MessageMismatch {
        if (!type.isBuiltIn()) {
            return checked(types.get(type.element()), received);
        }
        boolean fits = switch (type.element()) {
            case "bool" -> received.isBoolean();
            case "string" -> received.isTextual();
            case "time" -> received.isObject() || received.equals(TextNode.valueOf("now"));
            case "float32", "float64" -> received.isNumber();
            default -> received.isIntegralNumber() && isInRange(type.element(), received);
        };
        if (!fits) {
            throw mismatch(type, received);
        }
        return switch (type.element()) {
            case "time" -> time(received);
            case "float32" -> NODES.numberNode((double) received.floatValue());
            case "float64" -> NODES.numberNode(received.doubleValue());
            default -> received;
        };
    }

    private JsonNode time(JsonNode received) throws MessageMismatch {
        if (received.isTextual()) {
            return LongNode.valueOf(now.getAsLong());
        }
        RosVersion names =
                hasTime(received, types.version()) || !hasOtherTime(received) ? types.version() : RosVersion.ROS1;
        JsonNode seconds = received.path(names.seconds());
        JsonNode nanos = received.path(names.nanoseconds());
        if (!isWholeOrMissing(seconds) || !isWholeOrMissing(nanos)) {
            throw new MessageMismatch("a time needs whole numbers, not " + received);
        }
        return LongNode.valueOf(seconds.asLong() * NANOS_PER_SECOND + nanos.asLong());
    }

    private static boolean isWholeOrMissing(JsonNode number) {
        return number.isMissingNode() || number.canConvertToInt() && number.isIntegralNumber();
    }

    private boolean isInRange(String type, JsonNode number) {
        if (!number.canConvertToLong()) {
            return false;
        }
        long value = number.longValue();
        return switch (type) {
            case "int8" -> value == (byte) value;
            case "byte" -> types.version() == RosVersion.ROS1 ? value == (byte) value : value >= 0 && value <= 0xFF;
            case "uint8", "char" -> value >= 0 && value <= 0xFF;
            case "int16" -> value == (short) value;
            case "uint16" -> value >= 0 && value <= 0xFFFF;
            case "int32" -> value == (int) value;
            case "uint32" -> value >= 0 && value <= 0xFFFF_FFFFL;
            case "uint64" -> value >= 0;
            default -> true;
        };
    }

    private static MessageMismatch mismatch(FieldType type, JsonNode received) {
        return new MessageMismatch("a field of type " + type.element() + " cannot be " + received.getNodeType());
    }
}
