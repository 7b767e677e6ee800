package majic.ros.parameters;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.ros.readings.RosClient;
import majic.ros.readings.RosReadings;

/** Commands that show what is there: the list of topics, and one message of any of them. */
final class TopicCommands {
    private final RosAccess access;

    TopicCommands(RosAccess access) {
        this.access = access;
    }

    DriverCommand topics() {
        return new DriverCommand(
                "topics",
                List.of(),
                List.of(Parameter.text("word", "only topics whose name or type contains it")),
                false,
                "lists the topics of the robot with their types",
                (arguments, motion) -> list(arguments));
    }

    private String list(List<Value> words) {
        Map<String, String> all = new TreeMap<>(access.open().connection().listTopics());
        String listed = all.entrySet().stream()
                .filter(topic -> words.stream().allMatch(word -> contains(topic, word.toString())))
                .map(topic -> topic.getKey() + " (" + topic.getValue() + ")")
                .collect(Collectors.joining(", "));
        return listed.isEmpty() ? "none of " + all.size() + " topics" : listed;
    }

    private static boolean contains(Map.Entry<String, String> topic, String word) {
        return (topic.getKey() + " " + topic.getValue())
                .toLowerCase(Locale.ROOT)
                .contains(word.toLowerCase(Locale.ROOT));
    }

    DriverCommand topic() {
        return new DriverCommand(
                "topic",
                List.of(Parameter.text("name", "with the namespaces, as imu/data")),
                false,
                "shows the next message of a topic; get topic/NAME/FIELD reads one field",
                (arguments, motion) -> show(arguments.get(0).toString()));
    }

    private String show(String name) {
        RosReadings open = access.open();
        TopicPath path = find(open.connection(), name);
        Value shown = TopicParameters.read(
                open,
                path,
                message -> path.field().isEmpty()
                        ? Value.text(MessageFields.listed(message))
                        : MessageFields.shown(message, path.field()));
        if (shown instanceof Value.Unknown unknown) {
            String topic = path.topic().name();
            String reason = String.valueOf(unknown.reason());
            throw new BotException(reason.contains(topic) ? reason : topic + ": " + reason);
        }
        return shown.toString();
    }

    /** A topic that is not known may have appeared since the robot was connected. */
    private static TopicPath find(RosClient connection, String name) {
        try {
            return TopicPath.find(connection, name);
        } catch (ParameterException e) {
            connection.listTopics();
            return TopicPath.find(connection, name);
        }
    }
}
