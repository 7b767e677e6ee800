package majic.shared.desk;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.MessageLimit;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.Presence;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.UnusableMessageException;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * Shares the robots of a team over an MQTT 5 broker: publishes what they are and do, and lets one program at a time
 * command each of them from another desk. Halts a robot when its holder gives no sign of life for 1 s or is reported
 * gone, and all held robots when the broker is gone; nothing resumes by itself. Thread-safe.
 */
public final class DeskSharing implements AutoCloseable {
    private static final int CLIENT_ID_PART = 8;
    private static final int STRAYS_PER_S = 20;

    private final DeskOptions options;
    private final DeskContext desk;
    private final BrokerConnection connection;
    private final DeskWorker worker;
    private final DeskTimer timer;
    private final DeskPresence presence;
    private final Map<Integer, SharedRobot> robots = new ConcurrentSkipListMap<>();

    /** Topics of these robots, so that none is taken apart again for each command. */
    private final Map<String, SiteTopics.OfRobot> knownTopics = new ConcurrentHashMap<>();

    private final SharedTeam shared;
    private final @Nullable DeskFleet fleet;
    private final MessageLimit strays;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile @Nullable SiteLatch latch;
    private volatile boolean lost;
    private volatile String problem = "";

    /** Makes the connections of a desk. */
    @FunctionalInterface
    public interface ConnectionOpener {
        /**
         * Makes a connection that is not connected yet.
         *
         * @param clientId the name of the client at the broker
         * @param will the message that the broker publishes when the connection is lost
         * @return the connection
         */
        BrokerConnection open(String clientId, BrokerMessage will);
    }

    /**
     * Prepares the sharing of a team without a map; {@link #start()} begins it.
     *
     * @param team the robots
     * @param options what is shared, and under which name
     * @param opener makes the connection with the broker
     */
    public DeskSharing(Team team, DeskOptions options, ConnectionOpener opener) {
        this(team, options, opener, new DeskMap() {});
    }

    /**
     * Prepares the sharing; {@link #start()} begins it.
     *
     * @param team the robots
     * @param options what is shared, and under which name
     * @param opener makes the connection with the broker
     * @param map the map of the team
     */
    public DeskSharing(Team team, DeskOptions options, ConnectionOpener opener, DeskMap map) {
        Sender self = Sender.ofThisRun(options.desk(), options.person());
        SiteTopics topics = new SiteTopics(options.site());
        Presence here = new Presence(Presence.State.ONLINE, self, options.program(), List.of());
        this.options = options;
        this.connection = opener.open(clientId(self), DeskPresence.will(topics, here));
        this.worker = new DeskWorker(connection.time(), "desk " + self.desk() + " requests");
        this.timer = new DeskTimer(connection.time(), "desk " + self.desk() + " timer", this::tick);
        this.desk = new DeskContext(
                team, self, topics, connection, new DeskClock(connection.time()), worker, map, timer::wake);
        this.presence = new DeskPresence(desk, options.program(), this::robots, this::withdraw);
        this.fleet = options.vda5050() ? new DeskFleet(desk, options.site(), opener) : null;
        this.shared = new SharedTeam(desk, options.robots(), robots, presence, fleet);
        this.strays = new MessageLimit(connection.time(), STRAYS_PER_S);
    }

    private static String clientId(Sender self) {
        return "majic-" + self.desk() + "-" + self.session().substring(0, CLIENT_ID_PART);
    }

    /**
     * Connects, takes the name of the desk and publishes the robots. Blocks for at most 13 s.
     *
     * @throws ConnectFailed if there is no connection with the broker; with the reason and advice
     * @throws BotException if another desk has the name, or the broker does not let this user share robots; nothing is
     *     shared, and nothing stays open
     */
    public void start() {
        try {
            worker.start();
            connection.watch(new RefusedTopics(desk));
            connection.watch(new LossWatcher());
            connection.subscribe(desk.topics().presence(SiteTopics.ANY), Quality.AT_LEAST_ONCE, this::presenceReceived);
            connection.connect();
            presence.takeName();
            latch = new SiteLatch(desk.team(), connection, options.site(), desk.self());
            shared.begin();
            subscribe();
            timer.start();
        } catch (RuntimeException | Error e) {
            close();
            throw e;
        }
    }

    private void subscribe() {
        for (Part part : List.of(Part.STOP, Part.HOLD, Part.REQUEST, Part.SPEED)) {
            connection.subscribeUrgently(
                    desk.topics().robots(options.desk(), part), Quality.AT_LEAST_ONCE, this::received);
        }
        connection.subscribe(
                desk.topics().robots(options.desk(), Part.DESCRIPTION),
                Quality.AT_LEAST_ONCE,
                this::descriptionReceived);
    }

    private void received(BrokerMessage message) {
        topicOf(message.topic()).ifPresent(topic -> {
            SharedRobot robot = robots.get(topic.robot());
            if (robot != null) {
                knownTopics.putIfAbsent(message.topic(), topic);
                robot.received(topic.part(), message);
            } else if (strays.allows()) {
                desk.reply(
                        message,
                        RequestReply.of(
                                Outcome.REFUSED,
                                options.desk() + " has no robot " + topic.robot() + " (" + DeskContext.listing(robots())
                                        + ")"));
            }
        });
    }

    private Optional<SiteTopics.OfRobot> topicOf(String topic) {
        SiteTopics.OfRobot known = knownTopics.get(topic);
        return known == null ? desk.topics().ofRobot(topic) : Optional.of(known);
    }

    /** A description of another session is an old one of this desk, or one of a desk that has just lost the name. */
    private void descriptionReceived(BrokerMessage message) {
        desk.topics().ofRobot(message.topic()).ifPresent(topic -> {
            SharedRobot robot = robots.get(topic.robot());
            if (message.payload().length > 0 && !isOwn(message)) {
                if (robot != null) {
                    robot.publisher().repeat();
                } else {
                    desk.publish(BrokerMessage.removing(message.topic()));
                    desk.publish(BrokerMessage.removing(desk.topics().robot(topic.desk(), topic.robot(), Part.STATE)));
                }
            }
        });
    }

    private boolean isOwn(BrokerMessage message) {
        try {
            return Description.parse(message.payload())
                    .session()
                    .equals(desk.self().session());
        } catch (UnusableMessageException e) {
            return false;
        }
    }

    private void presenceReceived(BrokerMessage message) {
        String name = desk.topics().deskOfPresence(message.topic()).orElse("");
        try {
            Presence there = Presence.parse(message.payload());
            if (name.equals(options.desk())) {
                presence.received(there);
            } else if (there.state() != Presence.State.ONLINE) {
                String how = there.state() == Presence.State.OFFLINE ? " has ended" : " has no connection any more";
                halt(hold -> hold.holder().sessionHash().equals(there.sender().session()), name + how);
            }
        } catch (UnusableMessageException e) {
            if (strays.allows() && message.payload().length > 0) {
                worker.submit(() -> desk.team().notice(name + ": " + e.getMessage()));
            }
        }
    }

    /** Halts the held robots that are meant, then reports why. */
    private void halt(Predicate<RobotHold> meant, String why) {
        List<SharedRobot> held =
                robots.values().stream().filter(robot -> isHeldBy(robot, meant)).toList();
        SharedRobot.halt(held, desk);
        held.forEach(robot -> robot.notice(why + "; the robot is stopped"));
    }

    private static boolean isHeldBy(SharedRobot robot, Predicate<RobotHold> meant) {
        RobotHold hold = robot.hold();
        return hold != null && !hold.isRevoked() && meant.test(hold);
    }

    /** What is due at a time: states, missing heartbeats, unused holds. Returns the seconds until the next look. */
    private double tick() {
        List<SharedRobot> silent = robots.values().stream()
                .filter(robot -> isHeldBy(robot, hold -> hold.heartbeatLeftS() <= 0))
                .toList();
        SharedRobot.halt(silent, desk);
        silent.forEach(SharedRobot::reportSilence);
        double nextS = DeskTimer.PERIOD_S;
        for (SharedRobot robot : robots.values()) {
            robot.tick();
            RobotHold hold = robot.hold();
            nextS = hold == null || hold.isRevoked() ? nextS : Math.min(nextS, hold.heartbeatLeftS());
        }
        presence.publishChange();
        if (fleet != null) {
            fleet.tick();
        }
        return nextS;
    }

    private void withdraw(String why) {
        problem = why;
        connection.time().runAsync("withdrawing desk " + options.desk(), () -> {
            desk.team().notice("sharing has ended: " + why);
            close();
        });
    }

    /** Halts held robots when the broker is gone, and publishes everything again when it is back. */
    private final class LossWatcher implements BrokerConnection.Watcher {
        @Override
        public void connected() {
            if (lost) {
                lost = false;
                presence.publish();
                robots.values().forEach(robot -> robot.publisher().repeat());
                worker.submit(() -> desk.team().notice("sharing goes on: connected with the broker again"));
            }
        }

        @Override
        public void lost(String reason) {
            lost = true;
            halt(hold -> true, "the connection with the broker is lost (" + reason + ")");
            worker.submit(() -> desk.team()
                    .notice("sharing is interrupted: the connection with the broker is lost (" + reason
                            + "); it is being made again"));
        }

        /** A stop that cannot be read is still a stop. */
        @Override
        public void malformed(String topic, String problem) {
            topicOf(topic)
                    .filter(of -> of.part() == Part.STOP)
                    .map(of -> robots.get(of.robot()))
                    .ifPresent(SharedRobot::stopForMalformed);
            if (strays.allows()) {
                worker.submit(() -> desk.team().notice("a message on " + topic + " is left out: " + problem));
            }
        }
    }

    /**
     * Returns this desk as others see it.
     *
     * @return name, person and session
     */
    public Sender self() {
        return desk.self();
    }

    /**
     * Returns the numbers of the robots that are shared.
     *
     * @return ascending
     */
    public List<Integer> robots() {
        return List.copyOf(robots.keySet());
    }

    /**
     * Returns whether the robots can be reached by others at the moment.
     *
     * @return false before {@link #start()}, while the broker is gone, and after {@link #close()}
     */
    public boolean isConnected() {
        return !closed.get() && presence.isActive() && connection.isConnected();
    }

    /**
     * Returns why the sharing has ended by itself.
     *
     * @return one sentence; empty if it has not
     */
    public String problem() {
        return problem;
    }

    /** Halts the held robots, publishes that the desk has ended, and disconnects. Blocks for about a second at most. */
    @Override
    public void close() {
        if (!closed.compareAndSet(false, true)) {
            return;
        }
        halt(hold -> true, "sharing has ended");
        timer.close();
        SiteLatch joined = latch;
        if (joined != null) {
            joined.close();
        }
        shared.end();
        presence.end();
        worker.close();
        connection.close();
    }
}
