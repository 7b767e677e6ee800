package majic.aibo.session;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiVersion;
import org.jspecify.annotations.Nullable;

/**
 * The commands by which the dog reports its sensors periodically, and the way back from tags to sensors (URBI sheet 8).
 */
final class PollCommands {
    private final Tags tags;
    private final Map<String, Sensor> byTag = new HashMap<>();

    PollCommands(Tags tags) {
        this.tags = tags;
        for (Sensor sensor : Sensor.values()) {
            byTag.put(tags.named(sensor.tagName()), sensor);
        }
    }

    /** The order for all sensors of a rate; a name that the dog does not have spoils only its own reading. */
    String order(Sensor.Rate rate, UrbiVersion version) {
        String readings = rate.sensors().stream()
                .map(sensor -> version.labelled(tags.named(sensor.tagName()), sensor.expression()))
                .collect(Collectors.joining(" & "));
        return pollTag(rate) + ": every(" + rate.periodMs() + ") { " + readings + " },";
    }

    /** What ends all orders. */
    String stop() {
        StringBuilder stop = new StringBuilder();
        for (Sensor.Rate rate : Sensor.Rate.values()) {
            stop.append("stop ").append(pollTag(rate)).append(", ");
        }
        return stop.toString();
    }

    private String pollTag(Sensor.Rate rate) {
        return tags.named("poll" + rate.ordinal());
    }

    /** Returns the sensor that a message reports; null if none. */
    @Nullable
    Sensor sensor(UrbiMessage message) {
        return byTag.get(message.tag());
    }
}
