package majic.ros.graph;

import java.util.Optional;
import java.util.function.Function;

/**
 * By what a model of robot is recognised.
 *
 * @param graph the topics and nodes
 * @param namespace of the robot; empty for none
 * @param parameters reads a parameter by its name; called only for nodes that are there
 */
public record RobotEvidence(RosGraph graph, String namespace, Function<String, Optional<String>> parameters) {
    private static final double SAME_NUMBER = 0.02;

    boolean hasTopic(String pattern) {
        return graph.topics().keySet().stream()
                .filter(topic -> topic.startsWith(namespace + "/"))
                .anyMatch(topic -> matches(pattern, TopicNames.relative(topic, namespace)));
    }

    boolean hasType(String type) {
        return graph.topicsOf(type).stream().anyMatch(topic -> topic.startsWith(namespace + "/"));
    }

    boolean hasNode(String pattern) {
        return graph.nodes().stream().anyMatch(node -> matches(pattern, node.substring(node.lastIndexOf('/') + 1)));
    }

    boolean isNamespace(String pattern) {
        return !namespace.isEmpty() && matches(pattern, namespace.substring(1));
    }

    /**
     * Tests a parameter. In ROS 2 its name begins with that of its node, and rosapi waits long for a node that is not
     * there.
     */
    boolean hasParameter(String name, String value) {
        int colon = name.indexOf(':');
        boolean there = graph.isRos2() ? colon > 0 && graph.nodes().contains(name.substring(0, colon)) : colon < 0;
        return there
                && parameters.apply(name).filter(found -> isSame(found, value)).isPresent();
    }

    private static boolean isSame(String found, String value) {
        try {
            double number = Double.parseDouble(value);
            return Math.abs(Double.parseDouble(found) - number) <= SAME_NUMBER * Math.abs(number);
        } catch (NumberFormatException e) {
            return found.equalsIgnoreCase(value);
        }
    }

    /** Compares with a pattern in which a star stands for any characters. */
    private static boolean matches(String pattern, String name) {
        int star = pattern.indexOf('*');
        return star < 0
                ? pattern.equals(name)
                : name.length() >= pattern.length() - 1
                        && name.startsWith(pattern.substring(0, star))
                        && name.endsWith(pattern.substring(star + 1));
    }
}
