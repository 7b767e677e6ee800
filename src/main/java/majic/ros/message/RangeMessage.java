package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;

/**
 * A sonar, an infra-red or a time-of-flight sensor ({@code sensor_msgs/Range}). Immutable.
 *
 * @param frame of the sensor, which points along its x axis; empty if the message names none
 * @param measuredMm from the sensor, also outside of its limits and infinite; NaN without a number
 * @param leastMm the least range that it measures; 0 if it is not in the message
 * @param reachMm the greatest range that it measures; infinite if it is not in the message
 * @param openingDeg the full angle of its cone; 0 if it is not in the message
 */
public record RangeMessage(String frame, double measuredMm, double leastMm, double reachMm, double openingDeg) {
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
        return new RangeMessage(
                Fields.frame(message, "header.frame_id"),
                RosUnits.mm(Fields.measured(Fields.at(message, "range"))),
                RosUnits.mm(Fields.optional(message, "min_range").orElse(0)),
                RosUnits.mm(Fields.optional(message, "max_range").orElse(Double.POSITIVE_INFINITY)),
                Math.toDegrees(Fields.optional(message, "field_of_view").orElse(0)));
    }

    /**
     * Returns what the sensor measured.
     *
     * @return mm; empty outside its limits, where nothing is known
     */
    public OptionalDouble rangeMm() {
        return measuredMm >= leastMm && measuredMm <= reachMm && Double.isFinite(measuredMm)
                ? OptionalDouble.of(measuredMm)
                : OptionalDouble.empty();
    }
}
