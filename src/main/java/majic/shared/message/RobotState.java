package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/**
 * What a shared robot does and reports. Immutable.
 *
 * @param clock when it was written, ms of the clock of the desk that has the robot
 * @param link the connection of that desk with the robot
 * @param motion where the robot is and how it moves
 * @param latched whether STOP is latched at that desk
 * @param stops how often anybody but its holder has stopped it since the program of its desk was started
 * @param holder the program that may move the robot; null if it is free
 * @param stopProblem why its newest stop is not confirmed; null if it is, or there was none
 * @param values of all readable parameters, as {@link ValueJson} writes them
 */
public record RobotState(
        long clock,
        Link link,
        Movement motion,
        boolean latched,
        long stops,
        @Nullable Holder holder,
        @Nullable String stopProblem,
        Map<String, JsonNode> values) {
    /** A longer state is not used. */
    public static final int MOST_BYTES = 256 * 1024;

    private static final String WHAT = "state";

    /** Keeps a copy of the values. */
    public RobotState {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /**
     * The connection of a desk with its robot.
     *
     * @param connection its state
     * @param lostReason why it is lost; empty otherwise
     */
    public record Link(Connection connection, String lostReason) {
        /**
         * Returns the reason as the end of a sentence.
         *
         * @return {@code : cable pulled}; empty if there is none
         */
        public String because() {
            return lostReason.isEmpty() ? "" : ": " + lostReason;
        }
    }

    /**
     * Where a robot is and how it moves.
     *
     * @param pose relative to where it was placed or connected
     * @param placed whether it was placed, so that other robots may share the frame
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     * @param moving whether it moves or has been commanded to
     * @param ageMs since the robot reported this
     */
    public record Movement(Pose pose, boolean placed, double mmPerSec, double degPerSec, boolean moving, long ageMs) {}

    /**
     * The program that may move a robot.
     *
     * @param desk where the holder is; that of the robot itself for its own users, acts and scripts
     * @param person the holder
     * @param session the holder's session
     * @param work what the holder runs; empty if that is not known
     */
    public record Holder(String desk, String person, String session, String work) {
        /** Returns the name in messages: {@code Anna at desk1}. */
        @Override
        public String toString() {
            return person.isEmpty() ? desk : person + " at " + desk;
        }
    }

    /**
     * Returns whether another state says the same about the robot.
     *
     * @param other an earlier state; null for none
     * @return true if only the clock, the age of the report and the value of {@code age} differ
     */
    public boolean differsOnlyInTime(@Nullable RobotState other) {
        return other != null && timeless().equals(other.timeless());
    }

    private RobotState timeless() {
        Map<String, JsonNode> lasting = new LinkedHashMap<>(values);
        lasting.remove("age");
        Movement still = new Movement(motion.pose, motion.placed, motion.mmPerSec, motion.degPerSec, motion.moving, 0);
        return new RobotState(0, link, still, latched, stops, holder, stopProblem, lasting);
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("clock", clock);
        json.put("connection", link.connection.name().toLowerCase(Locale.ROOT));
        if (!link.lostReason.isEmpty()) {
            json.put("lostReason", link.lostReason);
        }
        json.putObject("pose")
                .put("x", rounded(motion.pose.xMm()))
                .put("y", rounded(motion.pose.yMm()))
                .put("heading", rounded(motion.pose.headingDeg()));
        json.put("placed", motion.placed).put("speed", rounded(motion.mmPerSec)).put("turn", rounded(motion.degPerSec));
        json.put("moving", motion.moving)
                .put("age", motion.ageMs)
                .put("latched", latched)
                .put("stops", stops);
        if (holder != null) {
            json.putObject("holder")
                    .put("desk", holder.desk)
                    .put("person", holder.person)
                    .put("session", holder.session)
                    .put("work", holder.work);
        }
        json.put("stop", stopProblem);
        ObjectNode all = json.putObject("values");
        values.forEach(all::set);
        return JsonObject.bytes(json);
    }

    private static double rounded(double number) {
        return Math.rint(number * 100) / 100;
    }

    /**
     * Reads a message. A connection that this version does not know counts as lost.
     *
     * @param payload JSON in UTF-8
     * @return the state
     * @throws UnusableMessageException if it is none
     */
    public static RobotState parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        Map<String, JsonNode> values = new LinkedHashMap<>();
        JsonNode all = json.node("values");
        if (all != null) {
            all.properties().forEach(field -> values.put(field.getKey(), field.getValue()));
        }
        return new RobotState(
                json.whole("clock"),
                new Link(connection(json.text("connection")), json.text("lostReason", "")),
                movement(json),
                json.flag("latched", false),
                json.whole("stops", 0),
                json.has("holder") ? holder(json.object("holder")) : null,
                json.has("stop") ? json.text("stop") : null,
                values);
    }

    private static Connection connection(String word) {
        for (Connection connection : Connection.values()) {
            if (connection.name().equalsIgnoreCase(word)) {
                return connection;
            }
        }
        return Connection.LOST;
    }

    private static Movement movement(JsonObject json) {
        JsonObject pose = json.object("pose");
        return new Movement(
                new Pose(pose.number("x"), pose.number("y"), pose.number("heading")),
                json.flag("placed", false),
                json.number("speed", 0),
                json.number("turn", 0),
                json.flag("moving", false),
                json.whole("age", 0));
    }

    private static Holder holder(JsonObject json) {
        return new Holder(
                json.text("desk", ""), json.text("person", ""), json.text("session", ""), json.text("work", ""));
    }
}
