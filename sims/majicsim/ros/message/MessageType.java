package majicsim.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A message type of one version of ROS. Immutable. */
public final class MessageType {
    static final String HEADER = "std_msgs/Header";

    private final String plainName;
    private final String fullName;
    private final List<Field> fields;

    MessageType(String plainName, String fullName, List<Field> fields) {
        this.plainName = plainName;
        this.fullName = fullName;
        this.fields = List.copyOf(fields);
    }

    /**
     * Package and name, the same in both versions.
     *
     * @return as {@code geometry_msgs/Twist}
     */
    public String plainName() {
        return plainName;
    }

    /**
     * The name in its version of ROS.
     *
     * @return as {@code geometry_msgs/msg/Twist}
     */
    public String fullName() {
        return fullName;
    }

    /**
     * Gives values the names of the fields, in order.
     *
     * @param values a list; surplus values are left out
     * @return an object
     */
    public ObjectNode named(JsonNode values) {
        ObjectNode named = JsonNodeFactory.instance.objectNode();
        for (int i = 0; i < Math.min(values.size(), fields.size()); i++) {
            named.set(fields.get(i).name(), values.get(i));
        }
        return named;
    }

    /**
     * Passes on the fields, as rosapi describes them.
     *
     * @param description receives one after the other
     */
    public void describe(FieldDescription description) {
        for (Field field : fields) {
            FieldType type = field.type();
            description.field(field.name(), type.element(), type.length(), example(type));
        }
    }

    private static String example(FieldType type) {
        if (type.isArray()) {
            return "[]";
        }
        if (type.isFloat()) {
            return "0.0";
        }
        return switch (type.element()) {
            case "string" -> "";
            case "bool" -> "False";
            default -> type.isBuiltIn() && !type.element().equals("time") ? "0" : "{}";
        };
    }

    /**
     * The types of its fields that are messages themselves.
     *
     * @param types all types
     * @return in the order of the fields
     */
    public List<MessageType> parts(MessageTypes types) {
        return fields.stream()
                .filter(field -> !field.type().isBuiltIn())
                .map(field -> types.get(field.type().element()))
                .toList();
    }

    List<Field> fields() {
        return fields;
    }

    @Nullable
    Field field(String name) {
        for (Field field : fields) {
            if (field.name().equals(name)) {
                return field;
            }
        }
        return null;
    }

    boolean isHeader() {
        return plainName.equals(HEADER);
    }

    /** Whether the first field is a header, whose number ROS 1 counts up with each message of a topic. */
    boolean hasHeader() {
        return !fields.isEmpty() && fields.get(0).type().element().equals(HEADER);
    }

    @Override
    public String toString() {
        return fullName;
    }

    /** Receives descriptions of fields. */
    public interface FieldDescription {
        /**
         * Reports a field.
         *
         * @param name its name
         * @param type of it or of its elements
         * @param length -1 for no array, 0 for a variable one, otherwise the number of elements
         * @param example a value as text
         */
        void field(String name, String type, int length, String example);
    }
}
