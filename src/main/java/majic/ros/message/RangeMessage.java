package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;

/**
 * A sonar, an infra-red or a time-of-flight sensor ({@code sensor_msgs/Range}). Immutable.
 *
 * @param frame of the sensor, which points along its x axis; empty if the message names none
 * @param rangeMm from the sensor; empty outside its limits, where nothing is known
 */
public record RangeMessage(String frame, OptionalDouble rangeMm) {
    /**
     * Reads a message.
     *
     * @param message the content of a {@code sensor_msgs/Range}
     * @return the reading
     * @throws UnusableMessage if the message has no field {@code range}
     */
    public static RangeMessage from(JsonNode message) {
        if (!message.has("range")) {
            throw new UnusableMessage("range has to be a number, not absent");
        }
        OptionalDouble range = Fields.optional(message, "range");
        double least = Fields.optional(message, "min_range").orElse(0);
        double most = Fields.optional(message, "max_range").orElse(Double.POSITIVE_INFINITY);
        boolean known = range.isPresent() && range.getAsDouble() >= least && range.getAsDouble() <= most;
        return new RangeMessage(
                Fields.frame(message, "header.frame_id"),
                known ? OptionalDouble.of(RosUnits.mm(range.getAsDouble())) : OptionalDouble.empty());
    }
}
