package majic.shared;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
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
import majic.shared.message.Presence;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.UnusableMessageException;
import majic.time.Signal;

/**
 * Finds the robots that are shared at a site, or by one desk of it: first the desks that are present with the numbers
 * of their robots, then the descriptions of one desk after the other. Brokers deliver only a limited number of retained
 * messages for each subscription (Mosquitto: {@code max_queued_messages}), so those that are missing are asked for one
 * by one.
 */
final class SiteListing {
    /** How long the broker may take to deliver the first of what it has kept, s. */
    private static final double FIRST_S = 3;

    /** How long it may take between two of them, s. */
    private static final double NEXT_S = 0.5;

    private static final int CLIENT_ID_PART = 8;

    private final BrokerOpener opener;
    private final BrokerAddress address;
    private final BotEnvironment environment;
    private final Map<String, Desk> desks = new ConcurrentSkipListMap<>();
    private final AtomicInteger arrivals = new AtomicInteger();
    private final Signal arrived;

    /** A desk of which the presence has arrived, and the descriptions of its robots that have. */
    private static final class Desk {
        private final BrokerAddress site;
        private final String name;
        private final Map<Integer, String> described = new ConcurrentHashMap<>();
        private volatile Presence presence;

        Desk(BrokerAddress site, String name, Presence presence) {
            this.site = site;
            this.name = name;
            this.presence = presence;
        }

        boolean isOnline() {
            return presence.state() == Presence.State.ONLINE;
        }

        List<Integer> missing() {
            return presence.robots().stream()
                    .filter(number -> !described.containsKey(number))
                    .toList();
        }

        String address(int robot) {
            return new SharedAddress(site, name, robot).toString();
        }
    }

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
     * @return what the robots are, by their addresses; also those of which no description has arrived. Robots of desks
     *     that are not present are left out
     * @throws ConnectFailed if the broker cannot be reached
     * @throws BotException if it refuses
     */
    Map<String, String> robots() {
        String id = "majic-list-" + UUID.randomUUID().toString().substring(0, CLIENT_ID_PART);
        try (BrokerConnection connection = opener.open(address, ConnectOptions.of(id, environment))) {
            connection.watch(new BrokerConnection.Watcher() {
                @Override
                public void malformed(String topic, String problem) {
                    malformedDescription(topic, problem);
                }
            });
            connection.connect();
            RobotWait waiting = new RobotWait(environment.time(), arrived);
            int before = arrivals.get();
            findDesks(connection, address, SiteTopics.ANY);
            desk().ifPresent(desk -> findDesks(connection, address.withSite(siteOfDesk()), desk));
            awaitArrivals(waiting, before, () -> false);
            desks.values().stream().filter(Desk::isOnline).forEach(desk -> describe(connection, desk, waiting));
        }
        return found();
    }

    /**
     * Waits until everything has arrived, or nothing more does.
     *
     * @param before the number of arrivals before the broker was asked
     */
    private void awaitArrivals(RobotWait waiting, int before, BooleanSupplier complete) {
        waiting.awaitConnecting(() -> complete.getAsBoolean() || arrivals.get() > before, FIRST_S);
        boolean more = !complete.getAsBoolean() && arrivals.get() > before;
        while (more) {
            int known = arrivals.get();
            waiting.awaitConnecting(() -> complete.getAsBoolean() || arrivals.get() > known, NEXT_S);
            more = !complete.getAsBoolean() && arrivals.get() > known;
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

    private void findDesks(BrokerConnection connection, BrokerAddress site, String desk) {
        SiteTopics topics = new SiteTopics(site.site());
        connection.subscribe(
                topics.presence(desk),
                Quality.AT_LEAST_ONCE,
                message -> topics.deskOfPresence(message.topic()).ifPresent(name -> present(site, name, message)));
    }

    private void present(BrokerAddress site, String name, BrokerMessage message) {
        try {
            Presence presence = Presence.parse(message.payload());
            desks.computeIfAbsent(site + "/" + name, key -> new Desk(site, name, presence)).presence = presence;
        } catch (UnusableMessageException e) {
            desks.remove(site + "/" + name);
        }
        arrived();
    }

    private void arrived() {
        arrivals.incrementAndGet();
        arrived.raise();
    }

    private void describe(BrokerConnection connection, Desk desk, RobotWait waiting) {
        if (desk.missing().isEmpty()) {
            return;
        }
        SiteTopics topics = new SiteTopics(desk.site.site());
        BrokerConnection.Handler handler = message -> described(desk, topics, message);
        int before = arrivals.get();
        connection.subscribe(topics.robots(desk.name, Part.DESCRIPTION), Quality.AT_LEAST_ONCE, handler);
        awaitArrivals(waiting, before, () -> desk.missing().isEmpty());
        int unknown = Integer.MAX_VALUE;
        for (List<Integer> missing = desk.missing();
                !missing.isEmpty() && missing.size() < unknown;
                missing = desk.missing()) {
            unknown = missing.size();
            ask(connection, desk, missing, handler, waiting);
        }
    }

    /** Asks for descriptions one by one: a broker leaves out what its queue does not hold. */
    private void ask(
            BrokerConnection connection,
            Desk desk,
            List<Integer> robots,
            BrokerConnection.Handler handler,
            RobotWait waiting) {
        SiteTopics topics = new SiteTopics(desk.site.site());
        int before = arrivals.get();
        for (int robot : robots) {
            connection.subscribe(topics.robot(desk.name, robot, Part.DESCRIPTION), Quality.AT_LEAST_ONCE, handler);
        }
        awaitArrivals(waiting, before, () -> desk.missing().isEmpty());
    }

    /** A description of another session is one of an earlier run of the desk. */
    private void described(Desk desk, SiteTopics topics, BrokerMessage message) {
        int robot =
                topics.ofRobot(message.topic()).map(SiteTopics.OfRobot::robot).orElse(0);
        try {
            Description description = Description.parse(message.payload());
            if (description.session().equals(desk.presence.sender().session())) {
                String what = description.kind().make();
                desk.described.put(robot, description.name().isEmpty() ? what : description.name() + ", " + what);
            }
        } catch (UnusableMessageException e) {
            desk.described.put(robot, String.valueOf(e.getMessage()));
        }
        arrived();
    }

    private void malformedDescription(String topic, String problem) {
        for (Desk desk : desks.values()) {
            new SiteTopics(desk.site.site())
                    .ofRobot(topic)
                    .filter(robot -> robot.desk().equals(desk.name) && robot.part() == Part.DESCRIPTION)
                    .ifPresent(robot -> desk.described.put(robot.robot(), "its description is malformed: " + problem));
        }
        arrived();
    }

    private Map<String, String> found() {
        Map<String, String> found = new TreeMap<>();
        desks.values().stream()
                .filter(Desk::isOnline)
                .forEach(desk -> desk.presence
                        .robots()
                        .forEach(robot -> found.put(
                                desk.address(robot),
                                desk.described.getOrDefault(robot, "no description has arrived"))));
        return found;
    }

    /**
     * Returns what was found as a question to users.
     *
     * @param robots the result of {@link #robots()}
     */
    String question(Map<String, String> robots) {
        String absent = desks.values().stream()
                .filter(desk -> desk.presence.state() == Presence.State.BROKEN)
                .map(desk -> "; " + desk.name + " has no connection with the broker")
                .collect(Collectors.joining());
        if (robots.isEmpty()) {
            return "no desk shares a robot there" + absent
                    + "; is the name right, and does a desk share its robots by ./majic --share " + address
                    + " --desk NAME?";
        }
        return "which robot is it: "
                + robots.entrySet().stream()
                        .map(robot -> robot.getKey() + " (" + robot.getValue() + ")")
                        .collect(Collectors.joining(", "))
                + absent + "?";
    }
}
