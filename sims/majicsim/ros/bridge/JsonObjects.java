package majicsim.ros.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** What the operations need for making objects. */
final class JsonObjects {
    private JsonObjects() {}

    static ObjectNode empty() {
        return JsonNodeFactory.instance.objectNode();
    }

    /** Writes an id as the client gave it, if it gave one. */
    static void writeId(JsonGenerator to, @Nullable JsonNode id) throws IOException {
        if (id != null && !id.isMissingNode() && !id.isNull()) {
            to.writeFieldName("id");
            to.writeTree(id);
        }
    }
}
