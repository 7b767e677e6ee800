package majic.ros.graph;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/**
 * One way to recognise a model of robot: all tests of a line of the table hold. Immutable.
 *
 * @param tests at least one
 */
record RobotSign(List<Predicate<RobotEvidence>> tests) {
    boolean isSeenIn(RobotEvidence evidence) {
        return tests.stream().allMatch(test -> test.test(evidence));
    }

    /**
     * Reads the words of a line behind {@code when}.
     *
     * @throws IllegalArgumentException if they are no tests; the message says what is wrong
     */
    static RobotSign parse(List<String> words) {
        List<Predicate<RobotEvidence>> tests = new ArrayList<>();
        int next = 0;
        while (next < words.size()) {
            String kind = words.get(next);
            int count = kind.equals("param") ? 2 : 1;
            if (next + count >= words.size()) {
                throw new IllegalArgumentException("\"" + kind + "\" needs " + count + " more word(s)");
            }
            tests.add(test(kind, words.subList(next + 1, next + 1 + count)));
            next += 1 + count;
        }
        if (tests.isEmpty()) {
            throw new IllegalArgumentException("\"when\" needs a test, such as \"node turtlebot3_node\"");
        }
        return new RobotSign(List.copyOf(tests));
    }

    private static Predicate<RobotEvidence> test(String kind, List<String> arguments) {
        String first = arguments.get(0);
        return switch (kind) {
            case "ros" -> evidence -> String.valueOf(evidence.graph().version()).equals(first);
            case "topic" -> evidence -> evidence.hasTopic(first);
            case "type" -> evidence -> evidence.hasType(first);
            case "node" -> evidence -> evidence.hasNode(first);
            case "namespace" -> evidence -> evidence.isNamespace(first);
            case "param" -> evidence -> evidence.hasParameter(first, arguments.get(1));
            default ->
                throw new IllegalArgumentException(
                        "\"" + kind + "\" is no test; there are ros, topic, type, node, namespace and param");
        };
    }
}
