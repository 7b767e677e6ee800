package majic.ros.bridge;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;

/**
 * Operations as text and as bytes. Accepts the words NaN and Infinity, which ROS 2 servers write into arrays of a fixed
 * size (rosbridge sheet 4), and never writes them: a server would publish them to the robot. Thread-safe.
 */
final class BridgeCodec {
    /** The first byte of a JSON object; one of CBOR begins with another. */
    private static final byte JSON_OBJECT = '{';

    private static final ObjectMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private BridgeCodec() {}

    /**
     * Decodes a text message.
     *
     * @throws IOException if it is no JSON object
     */
    static ObjectNode decode(String text) throws IOException {
        return object(JSON.readTree(text));
    }

    /**
     * Decodes a binary message, which is JSON or CBOR.
     *
     * @throws IOException if it is no object in either
     */
    static ObjectNode decode(byte[] bytes) throws IOException {
        return object(bytes.length > 0 && bytes[0] == JSON_OBJECT ? JSON.readTree(bytes) : CborTree.read(bytes));
    }

    private static ObjectNode object(JsonNode read) throws IOException {
        if (read instanceof ObjectNode operation) {
            return operation;
        }
        throw new IOException("not a JSON object: " + read.getNodeType());
    }

    /**
     * Encodes an operation.
     *
     * @throws IllegalArgumentException if a number in it is not finite
     */
    static String encode(ObjectNode operation) {
        requireFinite(operation);
        try {
            return JSON.writeValueAsString(operation);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("cannot be written as JSON: " + e.getOriginalMessage(), e);
        }
    }

    private static void requireFinite(JsonNode node) {
        if (node.isFloatingPointNumber() && !Double.isFinite(node.doubleValue())) {
            throw new IllegalArgumentException("a number that is sent to a robot must be finite: " + node);
        }
        node.forEach(BridgeCodec::requireFinite);
    }
}
