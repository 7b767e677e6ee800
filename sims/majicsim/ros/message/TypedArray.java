package majicsim.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.cbor.CBORGenerator;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Arrays of numbers in CBOR: bytes in little-endian order behind a tag that gives their type (RFC 8746, section 2.1).
 */
final class TypedArray {
    private TypedArray() {}

    /** Whether arrays of these elements have a tag. */
    static boolean exists(FieldType type) {
        return tag(type.element()) != 0;
    }

    static void write(CBORGenerator to, FieldType type, JsonNode values) throws IOException {
        int length = values.size();
        ByteBuffer bytes = ByteBuffer.allocate(length * Double.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < length; i++) {
            put(bytes, type.element(), values.path(i));
        }
        to.writeTag(tag(type.element()));
        to.writeBinary(bytes.array(), 0, bytes.position());
    }

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
