package majicsim.ros.rosapi;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import majicsim.ros.message.MessageType;
import majicsim.ros.message.MessageTypes;

/** Describes types: the fields of a type, and of the types in it. */
final class MessageDetails {
    private static final String SEPARATOR = "=".repeat(80) + "\n";

    private final MessageTypes types;

    MessageDetails(MessageTypes types) {
        this.types = types;
    }

    /** Answers about the message type of a request. */
    ObjectNode ofMessage(ObjectNode request) {
        return details(types.find(request.path("type").asText("")));
    }

    /** Answers about the request or the response of the service type of a request. */
    ObjectNode ofService(ObjectNode request, String part) {
        String plain =
                request.path("type").asText("").replaceFirst("/srv/", "/").replaceFirst("^rosapi_msgs/", "rosapi/");
        return details(types.find(plain + part));
    }

    private ObjectNode details(Optional<MessageType> outer) {
        ObjectNode details = JsonNodeFactory.instance.objectNode();
        ArrayNode definitions = details.putArray("typedefs");
        outer.ifPresent(type -> withParts(type).forEach(each -> describe(each, definitions.addObject())));
        return details;
    }

    private static void describe(MessageType type, ObjectNode definition) {
        definition.put("type", type.fullName());
        for (String list : new String[] {"fieldnames", "fieldtypes", "fieldarraylen", "examples"}) {
            definition.putArray(list);
        }
        type.describe((name, fieldType, length, example) -> {
            definition.withArray("fieldnames").add(name);
            definition.withArray("fieldtypes").add(fieldType);
            definition.withArray("fieldarraylen").add(length);
            definition.withArray("examples").add(example);
        });
    }

    /** A type and the types in it, each once. */
    private Collection<MessageType> withParts(MessageType outer) {
        Map<String, MessageType> seen = new LinkedHashMap<>();
        Deque<MessageType> open = new ArrayDeque<>(List.of(outer));
        while (!open.isEmpty()) {
            MessageType type = open.remove();
            if (seen.putIfAbsent(type.plainName(), type) == null) {
                type.parts(types).forEach(open::add);
            }
        }
        return seen.values();
    }

    /** The definition of a type as text, with those of the types in it behind lines of equals signs. */
    String text(MessageType outer) {
        StringBuilder text = new StringBuilder();
        for (MessageType type : withParts(outer)) {
            if (type != outer) {
                text.append(SEPARATOR).append("MSG: ").append(type.fullName()).append('\n');
            }
            type.describe((name, fieldType, length, example) -> text.append(fieldType)
                    .append(length < 0 ? "" : length == 0 ? "[]" : "[" + length + "]")
                    .append(' ')
                    .append(name)
                    .append('\n'));
        }
        return text.toString();
    }
}
