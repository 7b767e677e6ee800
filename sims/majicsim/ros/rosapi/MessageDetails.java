package majicsim.ros.rosapi;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import majicsim.ros.message.MessageType;
import majicsim.ros.message.MessageTypes;

/** Lists the fields of a type, and of the types in it. */
final class MessageDetails {
    private final MessageTypes types;

    MessageDetails(MessageTypes types) {
        this.types = types;
    }

    ObjectNode of(ObjectNode request) {
        ObjectNode details = JsonNodeFactory.instance.objectNode();
        ArrayNode definitions = details.putArray("typedefs");
        Deque<MessageType> open = new ArrayDeque<>();
        Set<String> seen = new HashSet<>();
        types.find(request.path("type").asText("")).ifPresent(open::add);
        while (!open.isEmpty()) {
            MessageType type = open.remove();
            if (seen.add(type.plainName())) {
                ObjectNode definition = definitions.addObject();
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
                type.parts(types).forEach(open::add);
            }
        }
        return details;
    }
}
