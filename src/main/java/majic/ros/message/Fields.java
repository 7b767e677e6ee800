package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.util.OptionalDouble;

/**
 * Reads fields of a message by their path, such as {@code pose.pose.position.x}. A number that is {@code null}, NaN or
 * infinite, or is not a number at all, is absent.
 */
final class Fields {
    private Fields() {}

    /** Returns the node at a path; a missing node if there is none. */
    static JsonNode at(JsonNode message, String path) {
        JsonNode node = message;
        for (String name : path.split("\\.")) {
            node = node.path(name);
        }
        return node == null ? MissingNode.getInstance() : node;
    }

    /**
     * Returns a number.
     *
     * @throws UnusableMessage if there is no finite number at the path
     */
    static double number(JsonNode message, String path) {
        return optional(message, path)
                .orElseThrow(() ->
                        new UnusableMessage(path + " has to be a finite number, not " + shown(at(message, path))));
    }

    /** Returns a number; empty if there is no finite number at the path. */
    static OptionalDouble optional(JsonNode message, String path) {
        return finite(at(message, path));
    }

    /** Returns the number of a node; empty if it is none, or not finite. */
    static OptionalDouble finite(JsonNode node) {
        return node.isNumber() && Double.isFinite(node.doubleValue())
                ? OptionalDouble.of(node.doubleValue())
                : OptionalDouble.empty();
    }

    /** Returns the number of a node, also an infinite one; NaN if it is none. */
    static double measured(JsonNode node) {
        return node.isNumber() ? node.doubleValue() : Double.NaN;
    }

    /**
     * Returns a list.
     *
     * @throws UnusableMessage if there is no list at the path
     */
    static JsonNode list(JsonNode message, String path) {
        JsonNode found = at(message, path);
        if (!found.isArray()) {
            throw new UnusableMessage(path + " has to be a list, not " + shown(found));
        }
        return found;
    }

    /** Returns a text; empty if there is none. */
    static String text(JsonNode message, String path) {
        return at(message, path).asText("");
    }

    /** Returns the name of the frame in which a message is given; ROS 1 may write it with a slash in front. */
    static String frame(JsonNode message, String path) {
        String name = text(message, path);
        return name.startsWith("/") ? name.substring(1) : name;
    }

    private static String shown(JsonNode node) {
        if (node.isMissingNode()) {
            return "absent";
        }
        return node.isContainerNode() ? "a list or an object" : node.toString();
    }
}
