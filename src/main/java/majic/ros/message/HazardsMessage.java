package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/**
 * What a Create 3 detects ({@code irobot_create_msgs/HazardDetectionVector}). Immutable. Each message lists all that is
 * detected at its time; an empty list means that there is nothing.
 *
 * @param detections in the order of the message
 */
public record HazardsMessage(List<Detection> detections) {
    /** Keeps a copy. */
    public HazardsMessage {
        detections = List.copyOf(detections);
    }

    /**
     * One hazard.
     *
     * @param hazard its kind
     * @param place the frame of the sensor, as {@code bump_front_left}; may be empty
     */
    public record Detection(Hazard hazard, String place) {}

    /**
     * Reads a message.
     *
     * @param message the content of a hazard detection vector
     * @return the hazards; of a number that is not known here {@link Hazard#OTHER}
     * @throws UnusableMessage if the detections are no list
     */
    public static HazardsMessage from(JsonNode message) {
        List<Detection> detections = new ArrayList<>();
        for (JsonNode detection : Fields.list(message, "detections")) {
            int number = detection.path("type").asInt(-1);
            Hazard hazard = number >= 0 && number < Hazard.OTHER.ordinal() ? Hazard.values()[number] : Hazard.OTHER;
            detections.add(new Detection(hazard, Fields.frame(detection, "header.frame_id")));
        }
        return new HazardsMessage(detections);
    }
}
