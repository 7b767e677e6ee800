package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;

/** A picture of a camera ({@code sensor_msgs/CompressedImage}). Immutable. */
public final class CompressedPicture {
    private final String format;
    private final byte[] file;

    private CompressedPicture(String format, byte[] file) {
        this.format = format;
        this.file = file;
    }

    /**
     * Reads a message, whose bytes may be base64 (JSON) or bytes (CBOR).
     *
     * @param message the content of a {@code sensor_msgs/CompressedImage}
     * @return the picture
     * @throws UnusableMessage if there are no bytes
     */
    public static CompressedPicture from(JsonNode message) {
        byte[] file = bytes(message.path("data"));
        if (file.length == 0) {
            throw new UnusableMessage("data has to be the bytes of a picture");
        }
        return new CompressedPicture(Fields.text(message, "format"), file);
    }

    private static byte[] bytes(JsonNode data) {
        try {
            byte[] found = data.binaryValue();
            return found == null ? new byte[0] : found;
        } catch (IOException e) {
            throw new UnusableMessage("data has to be the bytes of a picture in base64");
        }
    }

    /**
     * Returns the field {@code format}.
     *
     * @return contains {@code jpeg} or {@code png}, perhaps behind the encoding of the pixels; may be empty
     */
    public String format() {
        return format;
    }

    /**
     * Returns the size of the file.
     *
     * @return bytes, at least 1
     */
    public int size() {
        return file.length;
    }

    /**
     * Returns the bytes of the file.
     *
     * @return a copy, at least one byte
     */
    public byte[] file() {
        return file.clone();
    }
}
