package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What a shared robot reports otherwise than in its state or change before. Conditions, such as the connection or the
 * holder, never change by this: they are published as a whole {@link RobotState}. Immutable.
 *
 * @param clock when it was written, ms of the clock of the desk that has the robot
 * @param ageMs since the robot reported this
 * @param course where the robot is and how fast it moves; null if that has not changed
 * @param values those that have changed, as {@link ValueJson} writes them
 */
public record StateChange(long clock, long ageMs, RobotState.@Nullable Course course, Map<String, JsonNode> values) {
    private static final String WHAT = "change";

    /** Keeps a copy of the values. */
    public StateChange {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /**
     * Compares two states with the same conditions.
     *
     * @param before as it was published before
     * @param now the present state
     * @return what has changed
     */
    public static StateChange between(RobotState before, RobotState now) {
        Map<String, JsonNode> changed = new LinkedHashMap<>(now.values());
        changed.entrySet().removeAll(before.values().entrySet());
        RobotState.Course course = now.motion().course();
        return new StateChange(
                now.clock(), now.motion().ageMs(), course.equals(before.motion().course()) ? null : course, changed);
    }

    /**
     * Returns whether nothing has changed but the time.
     *
     * @return true if there is nothing to publish
     */
    public boolean isEmpty() {
        return course == null && values.isEmpty();
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("clock", clock).put("age", ageMs);
        if (course != null) {
            course.write(json);
        }
        if (!values.isEmpty()) {
            ObjectNode changed = json.putObject("values");
            values.forEach(changed::set);
        }
        return JsonObject.bytes(json);
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the change
     * @throws UnusableMessageException if it is none
     */
    public static StateChange parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, RobotState.MOST_BYTES);
        return new StateChange(
                json.whole("clock"),
                json.whole("age", 0),
                json.has("pose") ? RobotState.Course.read(json) : null,
                json.fields("values"));
    }
}
