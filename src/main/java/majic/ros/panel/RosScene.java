package majic.ros.panel;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.bot.MajicBot;
import majic.bot.Range;
import majic.ros.message.Hazard;

/**
 * A snapshot of what the panel of a ROS robot shows. Immutable.
 *
 * @param robot what does not change while it is connected
 * @param connection state of the connection
 * @param link how much arrives
 * @param scan the newest scan; empty without a scanner, or if the last one is too old
 * @param contacts what it touches or is endangered by now
 * @param battery its battery
 * @param topics the topics that are received, in the order of their names
 */
public record RosScene(
        Robot robot,
        MajicBot.Connection connection,
        Link link,
        Optional<ScanEchoes> scan,
        List<Contact> contacts,
        Battery battery,
        List<Topic> topics) {

    /** Keeps copies of the lists. */
    public RosScene {
        contacts = List.copyOf(contacts);
        topics = List.copyOf(topics);
    }

    /**
     * The robot.
     *
     * @param radiusMm of its hull, positive
     * @param speedLimits mm/s, both signs
     * @param turnLimits deg/s, both signs
     * @param hasScanner whether it has a scanner
     * @param hasContacts whether it reports contacts
     * @param hasCamera whether it has a camera
     */
    public record Robot(
            double radiusMm,
            Range speedLimits,
            Range turnLimits,
            boolean hasScanner,
            boolean hasContacts,
            boolean hasCamera) {}

    /**
     * The connection.
     *
     * @param silenceS since anything arrived, s
     * @param messagesPerSec of all topics together
     */
    public record Link(double silenceS, double messagesPerSec) {}

    /**
     * A contact or hazard that is there now.
     *
     * @param hazard its kind
     * @param place where, in the words of the robot; may be empty
     */
    public record Contact(Hazard hazard, String place) {}

    /**
     * The battery.
     *
     * @param volts empty if unknown
     * @param percent of the charge; empty if unknown
     * @param charging whether it is being charged
     * @param charger what the charger does, in words
     */
    public record Battery(OptionalDouble volts, OptionalInt percent, boolean charging, String charger) {
        /** Nothing is known. */
        public static final Battery UNKNOWN =
                new Battery(OptionalDouble.empty(), OptionalInt.empty(), false, "unknown");
    }

    /**
     * A topic that is received.
     *
     * @param name absolute
     * @param type as the robot names it
     * @param ageS since the newest message, s; positive infinity before the first one
     */
    public record Topic(String name, String type, double ageS) {}

    boolean isConnected() {
        return connection == MajicBot.Connection.CONNECTED;
    }

    /**
     * Returns this scene as the last one of an earlier connection, of which the newest scan does not count any more.
     */
    RosScene before(MajicBot.Connection now) {
        MajicBot.Connection other = now == MajicBot.Connection.CONNECTED ? MajicBot.Connection.CONNECTING : now;
        return new RosScene(robot, other, link, Optional.empty(), contacts, battery, topics);
    }
}
