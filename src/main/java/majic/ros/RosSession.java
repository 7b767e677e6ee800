package majic.ros;

import com.fasterxml.jackson.databind.JsonNode;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicSubscription;
import majic.ros.graph.Base;
import majic.ros.graph.BaseChoice;
import majic.ros.graph.BaseFinder;
import majic.ros.graph.KnownRobot;
import majic.ros.graph.KnownRobots;
import majic.ros.graph.OtherRobots;
import majic.ros.graph.RobotDescription;
import majic.ros.graph.RobotEvidence;
import majic.ros.graph.RosApi;
import majic.ros.graph.RosGraph;
import majic.ros.message.OdometryMessage;
import majic.ros.message.StampClock;
import majic.ros.message.UnusableMessage;
import majic.ros.message.VelocityForm;
import majic.time.SuspendDetector;
import majic.time.WaitPolicy;
import majic.velocity.VelocityOutput;
import org.jspecify.annotations.Nullable;

/**
 * One connection to a robot: finds its topics, receives its odometry, sends its velocities, and notices when the server
 * falls silent. Thread-safe.
 */
final class RosSession implements VelocityOutput {
    private static final Logger LOG = System.getLogger(RosSession.class.getName());

    private static final int ODOMETRY_THROTTLE_MS = 40;

    /** Longer than the time after which a silent topic is subscribed to again. */
    private static final double FIRST_ODOMETRY_S = 5;

    /** What a server takes to read a message: it discards what it has not read when the connection is closed. */
    private static final double LAST_STOP_S = 0.1;

    private static final double CLOSE_S = 0.2;

    /** How long the last stop waits for a server that is silent but still connected. */
    private static final double LINGER_S = 30;

    private static final double LINGER_STEP_S = 0.25;

    private final RosAddress address;
    private final RobotWait waiting;
    private final Events events;
    private final RosConnections connections;
    private final List<ServerWatch> watches = new CopyOnWriteArrayList<>();
    private final SuspendDetector suspend = new SuspendDetector();
    private final AtomicBoolean over = new AtomicBoolean();
    private final AtomicBoolean problemNoticed = new AtomicBoolean();
    private volatile @Nullable RosApi api;
    private volatile @Nullable RosGraph graph;
    private volatile @Nullable Base base;
    private volatile @Nullable VelocityForm form;
    private volatile StampClock stamps = new StampClock(false);
    private volatile OtherRobots others = new OtherRobots(List.of());
    private volatile KnownRobot robot = KnownRobots.UNKNOWN;
    private volatile boolean reporting;
    private volatile @Nullable String problem;

    /**
     * Handles what happens in a session. Called on threads that must not wait: readers, and those that watch the
     * server.
     */
    interface Events {
        /** Handles a message of the odometry, and when it was measured, on the driver's clock. */
        void odometry(RosSession from, OdometryMessage reading, long measuredNanos);

        /** Handles a message of the odometry that cannot be used; the reason is half a sentence. */
        void unusable(RosSession from, String reason);

        /** Handles the end of the connection; called at most once. */
        void lost(RosSession from, LinkLost cause);

        /** Handles a message for the user. */
        void notice(String message);
    }

    RosSession(RosAddress address, RobotWait waiting, Events events) {
        this.address = address;
        this.waiting = waiting;
        this.events = events;
        this.connections = new RosConnections(address.bridge(), waiting.time(), new Listener());
    }

    /**
     * Connects and finds the robot. Moves nothing.
     *
     * @param known the table of robots
     * @throws ConnectFailed if there is no server, or no robot that the address means
     */
    void find(KnownRobots known) {
        RosApi asking = new RosApi(connections.open(), address.namespace());
        RosGraph found = asking.graph();
        api = asking;
        BaseChoice choice = new BaseChoice(found, new BaseFinder(found, asking::subscribers), address.server());
        Base chosen = choice.choose(address.namespace(), address.base());
        others = choice.besides(chosen);
        robot = model(known, new RobotEvidence(found, chosen.namespace(), asking::parameter));
        // What the address names is used even if the table prefers another topic.
        base = address.base() == null ? KnownRobots.withTopics(robot, chosen, found) : chosen;
        graph = found;
        stamps = new StampClock(!found.hasSimulatedTime());
        form = VelocityForm.ofType(base().commandType()).orElseThrow();
        if (found.isRos2()) {
            connections.openServices();
        }
    }

    private KnownRobot model(KnownRobots known, RobotEvidence evidence) {
        String named = address.robot();
        if (named == null) {
            return known.recognise(evidence);
        }
        return known.named(named)
                .orElseThrow(() -> new ConnectFailed(
                        Reason.OTHER,
                        "there is no robot " + named + " in the table of robots; is it one of "
                                + String.join(", ", known.names()) + "?"));
    }

    /** Announces velocities. Moves nothing. */
    void advertise() {
        connections.drive().advertise(base().command(), graph().typeName(base().commandType()));
    }

    /**
     * Subscribes to the odometry, and waits for the first reading.
     *
     * @throws ConnectFailed if no usable odometry arrives
     */
    void awaitOdometry() {
        String odometry = base().odometry();
        if (odometry == null) {
            return;
        }
        connections
                .drive()
                .subscribe(
                        new TopicSubscription(odometry, graph().typeName(Base.ODOMETRY), ODOMETRY_THROTTLE_MS),
                        this::receiveOdometry);
        waiting.awaitConnecting(() -> reporting || over.get(), FIRST_ODOMETRY_S);
        if (!reporting && !over.get()) {
            throw new ConnectFailed(Reason.NO_ANSWER, noOdometry(odometry));
        }
    }

    private String noOdometry(String topic) {
        String unusable = problem;
        return unusable == null
                ? "the topic " + topic + " is there, but nothing arrives within " + FIRST_ODOMETRY_S
                        + " s; do the robot's own nodes run, or is it another topic, chosen by ?base=TOPIC?"
                : "the odometry " + topic + " cannot be used: " + unusable
                        + "; is it another topic, chosen by ?base=TOPIC?";
    }

    private void receiveOdometry(JsonNode message) {
        if (over.get()) {
            return;
        }
        try {
            OdometryMessage reading = OdometryMessage.from(message);
            long measured = stamps.measuredNanos(message, waiting.time().nanos(), roundTripS());
            events.odometry(this, reading, measured);
            // Last: the thread that waits for the first one reads the pose next.
            reporting = true;
            waiting.changes().raise();
        } catch (UnusableMessage e) {
            String reason = String.valueOf(e.getMessage());
            problem = reason;
            events.unusable(this, reason);
            waiting.changes().raise();
            if (reporting && problemNoticed.compareAndSet(false, true)) {
                events.notice("its odometry cannot be used: " + reason);
            }
        }
    }

    /** Watches the server from now on: the connection is lost when it falls silent. Called once. */
    void watch() {
        for (RosBridge bridge : connections.all()) {
            ServerWatch watch = new ServerWatch(waiting.time(), new Watched(bridge), this::endSilent);
            watches.add(watch);
            watch.start();
        }
        if (over.get()) {
            endWatches();
        }
    }

    private void endSilent() {
        end(new LinkLost("the rosbridge server has sent nothing for " + Value.plain(ServerWatch.SILENCE_S) + " s"));
    }

    private void endWatches() {
        watches.forEach(ServerWatch::close);
    }

    /**
     * Subscribes again to topics that are silent, and notices that the computer was suspended. Called about once a
     * second: the two clocks that this compares drift apart by more within hours.
     *
     * @throws LinkLost if the connection has ended, or the computer was suspended
     */
    void renewSubscriptions() {
        refuseAfterSuspend();
        connections.all().forEach(RosBridge::renewSilentSubscriptions);
    }

    @Override
    public void publish(double mmPerSec, double degPerSec) {
        VelocityForm used = form;
        if (used == null || over.get()) {
            throw new LinkLost("not connected");
        }
        if (mmPerSec != 0 || degPerSec != 0) {
            refuseAfterSuspend();
        }
        connections.drive().publish(base().command(), used.message(mmPerSec, degPerSec));
    }

    /**
     * A motion must not go on where it was interrupted: the robot may have been moved or have stopped by itself since
     * then.
     */
    private void refuseAfterSuspend() {
        if (suspend.wasSuspended()) {
            LinkLost cause = new LinkLost("this computer was asleep");
            // On another thread: this one may hold locks that the end of the session needs.
            waiting.time().runAsync("ros suspended", () -> WaitPolicy.without(() -> end(cause)));
            throw cause;
        }
    }

    /** Ends the session in order, after the last stop has had the time to reach the robot. */
    void close() {
        boolean wasOpen = over.compareAndSet(false, true);
        endWatches();
        if (wasOpen && base != null) {
            waiting.awaitClosing(() -> false, LAST_STOP_S);
            try {
                connections.drive().unadvertise(base().command());
            } catch (BotException e) {
                LOG.log(Level.DEBUG, "the announcement was not withdrawn", e);
            }
        }
        connections.close(CLOSE_S);
        waiting.changes().raise();
    }

    /** Cuts the connection of a session that could not begin. */
    void abort() {
        over.set(true);
        endWatches();
        connections.abort();
    }

    /** How long a message takes to the server and back at present, s; 0 if that is not known. */
    double roundTripS() {
        return connections.drive().roundTripS();
    }

    /** The topics and nodes at the time of the connection. */
    RosGraph graph() {
        return present(graph);
    }

    /** Returns the server and the topic of commands; empty before they were found. */
    Optional<String> identity() {
        return Optional.ofNullable(base).map(found -> address.serverAddress() + found.command());
    }

    /** The name of the node rosapi. */
    String rosapi() {
        return present(api).node();
    }

    /** The topics that drive the robot. */
    Base base() {
        return present(base);
    }

    /** The other robots behind the server. */
    OtherRobots others() {
        return others;
    }

    /** What is known about the robot. */
    KnownRobot robot() {
        return robot;
    }

    /**
     * Asks the robot which of its joints slide.
     *
     * @return their names; none if it has no description
     */
    Set<String> slidingJoints() {
        return RobotDescription.slidingJoints(present(api).on(connections.services()), graph(), base().namespace());
    }

    /** The topic of its camera that the address names; null if it names none. */
    @Nullable
    String camera() {
        return address.camera();
    }

    /** The connections, for parameters and commands. */
    RosConnections connections() {
        return connections;
    }

    private static <T> T present(@Nullable T value) {
        if (value == null) {
            throw new BotException("not connected");
        }
        return value;
    }

    private void end(LinkLost cause) {
        if (over.compareAndSet(false, true)) {
            endWatches();
            waiting.time().runAsync("ros last stop", this::stopAndClose);
            events.lost(this, cause);
        }
    }

    /**
     * Sends the last stop on each connection that is still open, and closes them when the server has had the time to
     * read it. A server discards what it has not read when a connection is closed ({@code IncomingQueue.finish} of
     * rosbridge_server). If the connections to a server that is only stuck were closed at once, it would go on with the
     * velocities before the stop.
     */
    private void stopAndClose() {
        VelocityForm used = form;
        Base driven = base;
        if (used != null && driven != null) {
            connections.all().forEach(bridge -> sendLastStop(bridge, driven.command(), used));
        }
        for (double waited = 0; waited < LINGER_S && isStuck(); waited += LINGER_STEP_S) {
            waiting.awaitClosing(() -> !connections.isOpen(), LINGER_STEP_S);
        }
        if (connections.isOpen()) {
            waiting.awaitClosing(() -> !connections.isOpen(), LAST_STOP_S);
        }
        connections.close(CLOSE_S);
    }

    private static void sendLastStop(RosBridge bridge, String topic, VelocityForm form) {
        try {
            if (bridge.isOpen()) {
                bridge.publish(topic, form.message(0, 0));
            }
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "the last stop was not sent", e);
        }
    }

    /** Whether a connection is open on which nothing has arrived since the last stop. */
    private boolean isStuck() {
        return connections.all().stream()
                .anyMatch(bridge -> bridge.isOpen() && bridge.silenceS() > ServerWatch.SILENCE_S);
    }

    /**
     * A connection that is watched.
     *
     * @param bridge the connection
     */
    private record Watched(RosBridge bridge) implements ServerWatch.Server {
        @Override
        public void ping() {
            bridge.ping();
        }

        @Override
        public double silenceS() {
            return bridge.silenceS();
        }
    }

    /** Handles the ends of the connections. */
    private final class Listener implements RosBridge.Listener {
        @Override
        public void lost(RosBridge bridge, LinkLost cause) {
            end(cause);
        }

        @Override
        public void notice(String message) {
            events.notice(message);
        }
    }
}
