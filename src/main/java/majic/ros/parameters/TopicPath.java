package majic.ros.parameters;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import majic.bot.ParameterException;
import majic.ros.readings.RosClient;
import majic.ros.readings.RosTopic;
import majic.text.Suggestion;

/**
 * A topic and a field of its messages, as users name them: {@code imu/data/angular_velocity/z}. Immutable.
 *
 * @param topic one that is there
 * @param field the names and indexes on the way to the field; empty for the whole message
 */
record TopicPath(RosTopic topic, List<String> field) {
    private static final int MOST_NEAR = 5;

    /**
     * Finds the topic that a path begins with. The longest name counts, and one in the robot's namespace before others;
     * upper and lower case are not distinguished, as in all names of parameters.
     *
     * @param path names with slashes between them, perhaps with one in front
     * @throws ParameterException if there is no such topic; the message lists near ones
     */
    static TopicPath find(RosClient connection, String path) {
        List<String> parts = List.of(path.replaceFirst("^/", "").split("/"));
        for (int length = parts.size(); length > 0; length--) {
            String name = "/" + String.join("/", parts.subList(0, length));
            Optional<RosTopic> found = topic(connection.topics(), connection.namespace() + name)
                    .or(() -> topic(connection.topics(), name));
            if (found.isPresent()) {
                return new TopicPath(found.get(), List.copyOf(parts.subList(length, parts.size())));
            }
        }
        throw new ParameterException(path, path + ": the robot has no such topic" + near(path, connection.topics()));
    }

    private static Optional<RosTopic> topic(Map<String, String> topics, String name) {
        return topics.entrySet().stream()
                .filter(topic -> topic.getKey().equalsIgnoreCase(name))
                .min(Comparator.comparing(topic -> topic.getKey().equals(name) ? 0 : 1))
                .map(topic -> new RosTopic(topic.getKey(), topic.getValue()));
    }

    /**
     * The end of a sentence: the topic that the path or its beginning was meant to be, or some that have a word of it.
     */
    static String near(String path, Map<String, String> topics) {
        String typed = path.replaceFirst("^/", "");
        List<String> names =
                topics.keySet().stream().map(name -> name.substring(1)).sorted().toList();
        for (String start = typed; !start.isEmpty(); start = start.substring(0, Math.max(0, start.lastIndexOf('/')))) {
            String suggestion = Suggestion.didYouMean(start, names);
            if (!suggestion.isEmpty()) {
                return suggestion;
            }
        }
        List<String> words = List.of(typed.toLowerCase(Locale.ROOT).split("[/_]"));
        String similar = names.stream()
                .filter(name -> words.stream().anyMatch(word -> isSimilar(name, word)))
                .limit(MOST_NEAR)
                .collect(Collectors.joining(", "));
        return similar.isEmpty() ? "; the command \"topics\" lists them" : "; near ones are " + similar;
    }

    private static boolean isSimilar(String name, String word) {
        String last = name.substring(name.lastIndexOf('/') + 1);
        return word.length() > 1 && (name.contains(word) || last.length() > 1 && word.contains(last));
    }
}
