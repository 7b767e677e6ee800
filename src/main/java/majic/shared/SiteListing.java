package majic.shared;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.driver.RobotWait;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.UnusableMessageException;
import majic.time.Signal;

/** Finds the robots that are shared at a site, or by one desk of it. */
final class SiteListing {
    /** How long the broker may take to deliver the first of what it has kept, s. */
    private static final double FIRST_S = 3;

    /** How long it may take between two of them, s. */
    private static final double NEXT_S = 0.5;

    private static final int CLIENT_ID_PART = 8;

    private final BrokerOpener opener;
    private final BrokerAddress address;
    private final BotEnvironment environment;
    private final Map<String, String> found = new ConcurrentSkipListMap<>();
    private final Signal arrived;

    /**
     * Lists a site.
     *
     * @param opener makes a connection for the list alone
     * @param address of a site, or of a desk: {@code mqtt://broker/lab} or {@code mqtt://broker/lab/desk2}
     */
    SiteListing(BrokerOpener opener, BrokerAddress address, BotEnvironment environment) {
        this.opener = opener;
        this.address = address;
        this.environment = environment;
        this.arrived = environment.time().signal();
    }

    /**
     * Asks the broker. Blocks for some seconds.
     *
     * @return what the robots are, by their addresses; empty if there are none
     * @throws ConnectFailed if the broker cannot be reached
     * @throws BotException if it refuses
     */
    Map<String, String> robots() {
        String id = "majic-list-" + UUID.randomUUID().toString().substring(0, CLIENT_ID_PART);
        try (BrokerConnection connection = opener.open(address, ConnectOptions.of(id, environment))) {
            connection.connect();
            collect(connection, address, SiteTopics.ANY);
            desk().ifPresent(desk -> collect(connection, address.withSite(siteOfDesk()), desk));
            await(new RobotWait(environment.time(), arrived));
        }
        return new TreeMap<>(found);
    }

    private void await(RobotWait waiting) {
        waiting.awaitConnecting(() -> !found.isEmpty(), FIRST_S);
        int known = 0;
        while (known < found.size()) {
            known = found.size();
            int before = known;
            waiting.awaitConnecting(() -> found.size() > before, NEXT_S);
        }
    }

    /** The last level may be the name of a desk. */
    private Optional<String> desk() {
        List<String> levels = address.levels();
        return levels.size() < 2 ? Optional.empty() : Optional.of(levels.get(levels.size() - 1));
    }

    private String siteOfDesk() {
        List<String> levels = new ArrayList<>(address.levels());
        levels.remove(levels.size() - 1);
        return String.join("/", levels);
    }

    private void collect(BrokerConnection connection, BrokerAddress site, String desk) {
        SiteTopics topics = new SiteTopics(site.site());
        connection.subscribe(
                topics.robots(desk, Part.DESCRIPTION),
                Quality.AT_LEAST_ONCE,
                message -> received(site, topics, message));
    }

    private void received(BrokerAddress site, SiteTopics topics, BrokerMessage message) {
        try {
            Optional<SiteTopics.OfRobot> robot = topics.ofRobot(message.topic());
            if (robot.isPresent() && message.payload().length > 0) {
                Description description = Description.parse(message.payload());
                String what = description.kind().make();
                found.put(
                        new SharedAddress(site, robot.get().desk(), robot.get().robot()).toString(),
                        description.name().isEmpty() ? what : description.name() + ", " + what);
            }
        } catch (UnusableMessageException e) {
            found.put(message.topic(), String.valueOf(e.getMessage()));
        }
        arrived.raise();
    }

    /** Returns what was found as a question to users. */
    static String question(BrokerAddress address, Map<String, String> robots) {
        if (robots.isEmpty()) {
            return "no desk shares a robot there; is the name right, and does a desk share its robots by ./majic --share "
                    + address + " --desk NAME?";
        }
        return "which robot is it: "
                + robots.entrySet().stream()
                        .map(robot -> robot.getKey() + " (" + robot.getValue() + ")")
                        .collect(Collectors.joining(", "))
                + "?";
    }
}
