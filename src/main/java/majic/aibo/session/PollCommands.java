package majic.aibo.session;

import java.util.Arrays;
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

    /**
     * The orders for all sensors.
     *
     * @param slowness how many times their usual period they are reported with
     */
    String start(int slowness, UrbiVersion version) {
        return Arrays.stream(Sensor.Rate.values())
                .map(rate -> order(rate, slowness, version))
                .collect(Collectors.joining(" "));
    }

    /** The order for all sensors of a rate; a name that the dog does not have spoils only its own reading. */
    private String order(Sensor.Rate rate, int slowness, UrbiVersion version) {
        String readings = rate.sensors().stream()
                .map(sensor -> version.labelled(tags.named(sensor.tagName()), sensor.expression()))
                .collect(Collectors.joining(" & "));
        return pollTag(rate, slowness) + ": every(" + slowness * rate.periodMs() + ") { " + readings + " },";
    }

    /** What ends the orders with this slowness; those with another have other tags, so they are not ended with them. */
    String stop(int slowness) {
        return Arrays.stream(Sensor.Rate.values())
                .map(rate -> "stop " + pollTag(rate, slowness) + ", ")
                .collect(Collectors.joining());
    }

    private String pollTag(Sensor.Rate rate, int slowness) {
        return tags.named("poll" + rate.ordinal() + "x" + slowness);
    }

    /** Returns the sensor that a message reports; null if none. */
    @Nullable
    Sensor sensor(UrbiMessage message) {
        return byTag.get(message.tag());
    }
}
