package majic.shared.desk;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.SiteTopics;

/**
 * Reports what the broker refuses of a sharing desk and what that means: once for each kind of topic and connection.
 */
final class RefusedTopics implements BrokerConnection.Watcher {
    private final DeskContext desk;
    private final Set<String> reported = ConcurrentHashMap.newKeySet();

    RefusedTopics(DeskContext desk) {
        this.desk = desk;
    }

    /** Another connection may have other rights. */
    @Override
    public void connected() {
        reported.clear();
    }

    @Override
    public void notPublished(BrokerMessage message, String reason) {
        report(
                message.topic(),
                "the broker refuses " + message.topic() + " (" + reason + "): " + meaning(message.topic()));
    }

    @Override
    public void notSubscribed(String filter, String reason) {
        report(
                filter,
                "the broker refuses the subscription to " + filter + " (" + reason + "): this desk receives nothing"
                        + " from there");
    }

    private void report(String topic, String words) {
        if (reported.add(topic.replaceAll("/\\d+/", "/+/"))) {
            desk.worker().submit(() -> desk.team().notice(words));
        }
    }

    private String meaning(String topic) {
        Optional<SiteTopics.OfRobot> robot = desk.topics().ofRobot(topic);
        if (robot.isEmpty()) {
            return desk.topics().deskOfPresence(topic).isPresent()
                    ? "other desks do not see this desk and its robots"
                    : "the commands of other desks stay without an answer";
        }
        int number = robot.get().robot();
        return switch (robot.get().part()) {
            case DESCRIPTION -> "other desks do not see robot " + number;
            case STATE -> "other desks receive no readings of robot " + number + " and cannot use it";
            case CHANGES -> "other desks receive the readings of robot " + number + " only once a second";
            case SCANS -> "other desks receive no scans of robot " + number;
            case MESSAGES -> "other desks receive no messages of robot " + number;
            case REQUEST, SPEED, STOP, HOLD -> "robot " + number + " does not receive it";
        };
    }
}
