package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majicsim.ros.message.MessageMismatch;

/** Reads the fields of operations, with the bridge's checks of their types. */
final class Fields {
    private Fields() {}

    /** A text that must be there. */
    static String text(JsonNode message, String field) throws MessageMismatch {
        JsonNode value = message.path(field);
        if (!value.isTextual()) {
            throw new MessageMismatch("the field " + field + " must be a text");
        }
        return value.textValue();
    }

    /** A whole number that may be missing. */
    static int number(JsonNode message, String field, int otherwise) throws MessageMismatch {
        JsonNode value = message.path(field);
        if (value.isMissingNode() || value.isNull()) {
            return otherwise;
        }
        if (!value.isIntegralNumber() || !value.canConvertToInt()) {
            throw new MessageMismatch("the field " + field + " must be a whole number");
        }
        return value.intValue();
    }

    /** The id, as a key; empty if there is none. */
    static String id(JsonNode message) {
        return message.path("id").asText("");
    }
}
