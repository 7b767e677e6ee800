package majic.ros.parameters;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.ros.readings.RequestedReading;
import majic.ros.readings.RosReadings;

/**
 * The fields of all topics as parameters: {@code get topic/imu/angular_velocity/z}. A topic is subscribed to while
 * something reads one of its fields. A parameter that was read once is listed, recorded and plotted like the others.
 */
final class TopicParameters implements ParameterTable.Finder {
    private static final String PREFIX = "topic/";

    private final RosAccess access;

    TopicParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public Optional<Found> find(String name) {
        if (!name.toLowerCase(Locale.ROOT).startsWith(PREFIX)) {
            return Optional.empty();
        }
        String path = name.substring(PREFIX.length());
        TopicPath found = access.find()
                .map(readings -> TopicPath.find(readings.connection(), path))
                .orElseThrow(() -> new ParameterException(name, name + ": the robot has not been connected yet"));
        String help = "a field of the topic " + found.topic().name() + ", in the robot's unit; requested when read";
        return Optional.of(
                new Found(Parameter.number(name, Unit.NONE, help), access.read(readings -> newest(readings, path))));
    }

    /** The topics may be others after the robot was connected again, so the path is looked up at each reading. */
    private static Value newest(RosReadings readings, String path) {
        TopicPath found;
        try {
            found = TopicPath.find(readings.connection(), path);
        } catch (ParameterException e) {
            return Value.unknown("the robot has no such topic now");
        }
        return read(readings, found, message -> MessageFields.value(message, found.field()));
    }

    static Value read(RosReadings readings, TopicPath path, Function<JsonNode, Value> reader) {
        Optional<RequestedReading<JsonNode>> topic = readings.topic(path.topic());
        return topic.map(reading -> reading.read().map(reader).orElseGet(reading::unknown))
                .orElse(Value.unknown("too many topics are read already"));
    }
}
