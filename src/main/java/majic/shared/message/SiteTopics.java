package majic.shared.message;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The topics of one site, version 1. Immutable.
 *
 * @param site one or more levels with slashes between them
 */
public record SiteTopics(String site) {
    /** Stands for one level in a filter. */
    public static final String ANY = "+";

    private static final String VERSION = "/majic/1/";
    private static final Pattern OF_ROBOT = Pattern.compile("desks/([^/]+)/robots/(\\d{1,9})/([a-z]+)");
    private static final Pattern PRESENCE = Pattern.compile("desks/([^/]+)/presence");

    /** What a topic of one robot is for. */
    public enum Part {
        /** What the robot is and can do; retained. */
        DESCRIPTION,
        /** What the robot does and reports; retained. */
        STATE,
        /** What has changed in the reports of the robot since its last state. */
        CHANGES,
        /** What the range sensors of the robot measure, while another desk asks for it. */
        SCANS,
        /** Messages, answers and alarms of the robot. */
        MESSAGES,
        /** Requests to the robot. */
        REQUEST,
        /** Speeds for the next 600 ms. */
        SPEED,
        /** Stops. */
        STOP,
        /** Heartbeats of the holder. */
        HOLD;

        private final String level = name().toLowerCase(Locale.ROOT);
    }

    /**
     * A topic of one robot.
     *
     * @param desk the desk that has the robot
     * @param robot its number at that desk
     * @param part what the topic is for
     */
    public record OfRobot(String desk, int robot, Part part) {}

    /**
     * Returns the topic of the STOP of the whole team.
     *
     * @return the topic
     */
    public String stop() {
        return site + VERSION + "stop";
    }

    /**
     * Returns the topic of a desk's presence.
     *
     * @param desk its name, or {@link #ANY}
     * @return the topic or filter
     */
    public String presence(String desk) {
        return site + VERSION + "desks/" + desk + "/presence";
    }

    /**
     * Returns the filter for everything that a sharing desk publishes about itself and its robots.
     *
     * @param desk its name
     * @return the filter
     */
    public String desk(String desk) {
        return site + VERSION + "desks/" + desk + "/#";
    }

    /**
     * Returns the desk whose presence a topic is for.
     *
     * @param topic any
     * @return the name; empty for another topic
     */
    public Optional<String> deskOfPresence(String topic) {
        return match(PRESENCE, topic).map(found -> found.group(1));
    }

    /**
     * Returns a topic of a robot.
     *
     * @param desk the desk that has it
     * @param robot its number there
     * @param part what the topic is for
     * @return the topic
     */
    public String robot(String desk, int robot, Part part) {
        return ofRobot(desk, String.valueOf(robot), part);
    }

    /**
     * Returns the filter for one topic of all robots.
     *
     * @param desk the desk that has them, or {@link #ANY}
     * @param part what the topics are for
     * @return the filter
     */
    public String robots(String desk, Part part) {
        return ofRobot(desk, ANY, part);
    }

    private String ofRobot(String desk, String robot, Part part) {
        return site + VERSION + "desks/" + desk + "/robots/" + robot + "/" + part.level;
    }

    /**
     * Reads a topic of a robot.
     *
     * @param topic any
     * @return empty for another topic
     */
    public Optional<OfRobot> ofRobot(String topic) {
        return match(OF_ROBOT, topic)
                .flatMap(found -> part(found.group(3))
                        .map(part -> new OfRobot(found.group(1), Integer.parseInt(found.group(2)), part)));
    }

    private static Optional<Part> part(String level) {
        for (Part part : Part.values()) {
            if (part.level.equals(level)) {
                return Optional.of(part);
            }
        }
        return Optional.empty();
    }

    /**
     * Returns the topic of the answers to one program.
     *
     * @param program a text that only the program that asks uses; not its session, because others can read the topic
     * @return the topic
     */
    public String replies(String program) {
        return site + VERSION + "replies/" + program;
    }

    private Optional<Matcher> match(Pattern pattern, String topic) {
        String start = site + VERSION;
        if (!topic.startsWith(start)) {
            return Optional.empty();
        }
        Matcher matcher = pattern.matcher(topic.substring(start.length()));
        return matcher.matches() ? Optional.of(matcher) : Optional.empty();
    }
}
