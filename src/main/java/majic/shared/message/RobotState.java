package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
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
 * @param stops how often it was stopped otherwise than by its holder since the program of its desk was started
 * @param holder the program that may move the robot; null if it is free
 * @param stopProblem why its newest stop is not confirmed; null if it is, or there was none
 * @param values of all readable parameters but {@link #NOT_IN_VALUES}, as {@link ValueJson} writes them
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

    /** Parameters whose values are not repeated among the values: {@link Movement} has them. */
    public static final Set<String> NOT_IN_VALUES =
            Set.of("x", "y", "heading", "pose", "speed", "turnRate", "moving", "age");

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
     * @param origin of its odometry, in the frame of the pose
     * @param placed whether it was placed, so that other robots may share the frame
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     * @param moving whether it moves or has been commanded to
     * @param ageMs since the robot reported this
     */
    public record Movement(
            Pose pose, Pose origin, boolean placed, double mmPerSec, double degPerSec, boolean moving, long ageMs) {
        /** Rounds to hundredths of a unit, as messages do. */
        public Movement {
            pose = rounded(pose);
            origin = rounded(origin);
            mmPerSec = rounded(mmPerSec);
            degPerSec = rounded(degPerSec);
        }

        Course course() {
            return new Course(pose, origin, mmPerSec, degPerSec);
        }

        Movement on(Course other, long otherAgeMs) {
            return new Movement(other.pose, other.origin, placed, other.mmPerSec, other.degPerSec, moving, otherAgeMs);
        }
    }

    /**
     * The part of a {@link Movement} that a robot reports all the time.
     *
     * @param pose relative to where it was placed or connected
     * @param origin of its odometry, in the frame of the pose
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     */
    public record Course(Pose pose, Pose origin, double mmPerSec, double degPerSec) {
        static Course read(JsonObject json) {
            return new Course(
                    json.pose("pose"),
                    json.has("origin") ? json.pose("origin") : Pose.START,
                    json.number("speed", 0),
                    json.number("turn", 0));
        }

        void write(ObjectNode json) {
            JsonObject.put(json, "pose", pose);
            if (!origin.equals(Pose.START)) {
                JsonObject.put(json, "origin", origin);
            }
            json.put("speed", mmPerSec).put("turn", degPerSec);
        }
    }

    /**
     * The program that may move a robot.
     *
     * @param desk where the holder is; that of the robot itself for its own users, acts and scripts
     * @param person the holder
     * @param sessionHash by which the holder recognises itself ({@link Sender#sessionHash})
     * @param work what the holder runs; empty if that is not known
     */
    public record Holder(String desk, String person, String sessionHash, String work) {
        /** Returns the name in messages: {@code Anna at desk1}. */
        @Override
        public String toString() {
            return person.isEmpty() ? desk : person + " at " + desk;
        }
    }

    /**
     * Returns whether another state of the same robot differs in what a {@link StateChange} contains, and in nothing
     * else.
     *
     * @param other an earlier or later state
     * @return false if a condition differs, such as the holder, or the names of the values
     */
    public boolean hasConditionsOf(RobotState other) {
        return conditions().equals(other.conditions());
    }

    private List<@Nullable Object> conditions() {
        return Arrays.asList(link, motion.placed, motion.moving, latched, stops, holder, stopProblem, values.keySet());
    }

    /**
     * Returns the state after a change.
     *
     * @param change was published after this state
     * @return with the clock, the age and all values of the change; the rest is as before
     */
    public RobotState with(StateChange change) {
        Course course = change.course() == null ? motion.course() : change.course();
        Map<String, JsonNode> newest = new LinkedHashMap<>(values);
        newest.putAll(change.values());
        return new RobotState(
                change.clock(), link, motion.on(course, change.ageMs()), latched, stops, holder, stopProblem, newest);
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
        motion.course().write(json);
        json.put("placed", motion.placed);
        json.put("moving", motion.moving)
                .put("age", motion.ageMs)
                .put("latched", latched)
                .put("stops", stops);
        if (holder != null) {
            json.putObject("holder")
                    .put("desk", holder.desk)
                    .put("person", holder.person)
                    .put("sessionHash", holder.sessionHash)
                    .put("work", holder.work);
        }
        json.put("stop", stopProblem);
        ObjectNode all = json.putObject("values");
        values.forEach(all::set);
        return JsonObject.bytes(json);
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
        return new RobotState(
                json.whole("clock"),
                new Link(connection(json.text("connection")), json.text("lostReason", "")),
                movement(json),
                json.flag("latched", false),
                json.whole("stops", 0),
                json.has("holder") ? holder(json.object("holder")) : null,
                json.has("stop") ? json.text("stop") : null,
                json.fields("values"));
    }

    /** Rounds to hundredths of a unit. */
    static Pose rounded(Pose pose) {
        return new Pose(rounded(pose.xMm()), rounded(pose.yMm()), rounded(pose.headingDeg()));
    }

    private static double rounded(double number) {
        double rounded = Math.rint(number * 100) / 100;
        return rounded == 0 ? 0 : rounded;
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
        Course course = Course.read(json);
        return new Movement(
                course.pose,
                course.origin,
                json.flag("placed", false),
                course.mmPerSec,
                course.degPerSec,
                json.flag("moving", false),
                json.whole("age", 0));
    }

    private static Holder holder(JsonObject json) {
        return new Holder(
                json.text("desk", ""), json.text("person", ""), json.text("sessionHash", ""), json.text("work", ""));
    }
}
