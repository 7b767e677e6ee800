package majic.shared;

import java.util.stream.Collectors;
import majic.shared.message.Presence;

/** Explains why a shared robot cannot be connected, from what has arrived from its desk. */
final class Absence {
    private Absence() {}

    /** Returns a sentence for users. */
    static String of(SharedAddress address, RobotFeed feed) {
        String desk = address.desk();
        String end = feed.end();
        if (end != null) {
            return end;
        }
        Presence presence = feed.presence();
        if (presence == null) {
            return "no desk " + desk + " shares robots at " + address.broker()
                    + "; is it running, and is it the right name?";
        }
        return switch (presence.state()) {
            case OFFLINE -> desk + " does not share its robots at the moment; is it running?";
            case BROKEN -> desk + " has lost its connection to the broker; is it running?";
            case ONLINE -> ofRobot(address, presence, feed);
        };
    }

    private static String ofRobot(SharedAddress address, Presence presence, RobotFeed feed) {
        if (!presence.robots().contains(address.robot())) {
            return address.desk() + " shares no robot " + address.robot() + " (" + shared(presence)
                    + "); is the number right?";
        }
        RobotFeed.Received first = feed.state();
        if (feed.description() == null || first == null) {
            String what = feed.description() == null ? "describes" : "reports the state of";
            return address.desk() + " shares robot " + address.robot() + ", but never " + what
                    + " it; may this user read all topics of the broker?";
        }
        return address.desk() + " is not connected to its robot " + address.robot() + " at the moment"
                + first.state().link().because() + "; is it switched on, and connected there?";
    }

    private static String shared(Presence presence) {
        if (presence.robots().isEmpty()) {
            return "it shares none";
        }
        return "it shares " + presence.robots().stream().map(String::valueOf).collect(Collectors.joining(", "));
    }
}
