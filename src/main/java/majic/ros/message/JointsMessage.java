package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Wheels and other joints ({@code sensor_msgs/JointState}). Immutable.
 *
 * @param joints in the order of the message
 */
public record JointsMessage(List<JointReading> joints) {
    /** Keeps a copy. */
    public JointsMessage {
        joints = List.copyOf(joints);
    }

    /**
     * One joint. The message does not say whether a joint turns or slides, so the numbers are as they were sent.
     *
     * @param name as the robot's description has it
     * @param position radians, or metres for a joint that slides; empty if not reported
     * @param velocity radians or metres a second; empty if not reported
     */
    public record JointReading(String name, OptionalDouble position, OptionalDouble velocity) {}

    /**
     * Reads a message.
     *
     * @param message the content of a {@code sensor_msgs/JointState}, whose lists of numbers may be empty
     * @return the joints
     * @throws UnusableMessage if the names are no list
     */
    public static JointsMessage from(JsonNode message) {
        List<JointReading> joints = new ArrayList<>();
        for (JsonNode name : Fields.list(message, "name")) {
            int index = joints.size();
            joints.add(new JointReading(
                    name.asText(""),
                    Fields.finite(message.path("position").path(index)),
                    Fields.finite(message.path("velocity").path(index))));
        }
        return new JointsMessage(joints);
    }
}
