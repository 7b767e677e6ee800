package majic.shared.vda5050;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Clock;
import java.util.Optional;
import java.util.function.BiFunction;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.MajicBot;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.vda5050.ActionStates.Status;
import majic.shared.vda5050.VehicleHeader.Topic;
import majic.team.Member;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * One shared robot as a vehicle of VDA 5050, version 2.0.0, with a connection of its own for its last will.
 * Thread-safe.
 *
 * <p>What fits: {@code connection}, {@code state}, {@code factsheet}, and the instant actions {@code startPause},
 * {@code cancelOrder}, {@code stateRequest} and {@code factsheetRequest}. What does not: a robot of MAJIC follows no
 * route of nodes and edges, so orders are rejected, the operating mode is always {@code MANUAL}, and node and edge
 * states are empty. {@code startPause} stops the robot, and {@code stopPause} fails, because nothing resumes by itself.
 * {@code cancelOrder} stops the robot although there is no order. {@code paused} and {@code eStop} show a latched STOP.
 * Few robots report their charge; an entry in {@code information} says so. The factsheet has a circle for the outline,
 * and zero for masses, heights and accelerations, which are not known here; other instant actions fail.
 */
public final class FleetVehicle implements AutoCloseable {
    /** The shortest time between two states without an event, seconds. */
    static final double SHORTEST_S = 1;

    /** The specification demands a state every 30 s at least. */
    private static final double LONGEST_S = 10;

    private static final String STOPPED_BY = "fleet control (VDA 5050)";

    private final Team team;
    private final StoppableRobot robot;
    private final BrokerConnection connection;
    private final VehicleHeader header;
    private final String map;
    private final ActionStates actions = new ActionStates();
    private volatile String rejected = "";
    private volatile String shown = "";
    private volatile long publishedNanos;
    private volatile boolean online;
    private volatile boolean closed;

    /**
     * Creates the vehicle; {@link #start()} connects it.
     *
     * @param team which may be latched
     * @param robot the robot
     * @param site the levels of the topics before those of the specification
     * @param desk the name of the desk that has the robot
     * @param opener makes a connection that is not connected yet from a client id and a last will
     */
    public FleetVehicle(
            Team team,
            StoppableRobot robot,
            String site,
            String desk,
            BiFunction<String, BrokerMessage, BrokerConnection> opener) {
        this.team = team;
        this.robot = robot;
        this.map = desk;
        String serialNumber = desk + "-" + robot.member().number();
        this.header = new VehicleHeader(site, serialNumber, Clock.systemUTC());
        this.connection = opener.apply("vda5050-" + serialNumber, header.connection("CONNECTIONBROKEN"));
    }

    /**
     * Connects and publishes. Blocks for 8 s at most.
     *
     * @throws ConnectFailed if there is no connection with the broker
     */
    public void start() {
        connection.subscribe(header.topic(Topic.INSTANT_ACTIONS), Quality.AT_LEAST_ONCE, this::actionsReceived);
        connection.subscribe(
                header.topic(Topic.ORDER),
                Quality.AT_LEAST_ONCE,
                message -> reject("orderError", "orders are not" + " supported; use the topics of MAJIC"));
        connection.watch(new BrokerConnection.Watcher() {
            @Override
            public void connected() {
                publish(header.connection("ONLINE"));
                publishFactsheet();
                online = true;
                publishState();
            }

            @Override
            public void lost(String reason) {
                online = false;
            }

            @Override
            public void notPublished(BrokerMessage message, String reason) {
                robot.notice("fleet tools do not see it as a vehicle of VDA 5050: the broker refuses " + message.topic()
                        + " (" + reason + ")");
            }
        });
        connection.connect();
    }

    private void publish(BrokerMessage message) {
        try {
            connection.publish(message);
        } catch (BotException e) {
            // Everything is published again with the next connection.
            publishedNanos = 0;
        }
    }

    private void publishFactsheet() {
        ObjectNode factsheet = header.begin(Topic.FACTSHEET);
        VehicleJson.factsheet(factsheet, bot());
        publish(header.message(Topic.FACTSHEET, factsheet));
    }

    private MajicBot bot() {
        return robot.member().bot();
    }

    /** Publishes the state if it is due: at once after an event, every second while the robot moves. */
    public void tick() {
        double sinceS = connection.time().secondsSince(publishedNanos);
        boolean due = sinceS >= LONGEST_S || (bot().state().moving() && sinceS >= SHORTEST_S);
        if (!closed && (due || !events().equals(shown))) {
            publishState();
        }
    }

    /** What has to be reported at once when it changes. */
    private String events() {
        return bot().connection() + " " + bot().state().moving() + " " + team.isLatched() + " " + stopProblem() + " "
                + rejected;
    }

    private Optional<String> stopProblem() {
        return team.stopStatus().problem(robot.member().number());
    }

    /** Before the vehicle is online nothing could be sent, and the number of the message would be used up. */
    private synchronized void publishState() {
        if (!online || !connection.isConnected()) {
            return;
        }
        Member member = robot.member();
        publishedNanos = connection.time().nanos();
        shown = events();
        ObjectNode state = header.begin(Topic.STATE);
        boolean placed = bot().placedAt().isPresent();
        VehicleJson.state(state, member, placed ? map : map + "-" + member.number(), team.isLatched());
        actions.write(state.putArray("actionStates"));
        errors(state.putArray("errors"));
        publish(header.message(Topic.STATE, state));
    }

    private void errors(ArrayNode to) {
        bot().lostReason().ifPresent(reason -> error(to, "connectionLost", "FATAL", reason));
        stopProblem().ifPresent(reason -> error(to, "stopNotConfirmed", "FATAL", reason));
        String now = rejected;
        if (!now.isEmpty()) {
            error(to, now.substring(0, now.indexOf(' ')), "WARNING", now.substring(now.indexOf(' ') + 1));
        }
    }

    private static void error(ArrayNode to, String type, String level, String description) {
        to.addObject().put("errorType", type).put("errorLevel", level).put("errorDescription", description);
    }

    /** Reports a message that was not used, until one can be used. Runs on the thread of the connection. */
    private void reject(String type, String why) {
        rejected = type + " " + why;
        publishState();
    }

    private void actionsReceived(BrokerMessage message) {
        if (message.retained() || message.payload().length == 0) {
            return;
        }
        try {
            InstantAction.parse(message.payload()).forEach(this::begin);
            rejected = "";
        } catch (BotException e) {
            reject("validationError", "instantActions: " + e.getMessage());
            return;
        }
        publishState();
    }

    private void begin(InstantAction action) {
        if (!actions.begin(action.id(), action.type())) {
            return;
        }
        switch (action.type()) {
            case "startPause", "cancelOrder" ->
                robot.stop(STOPPED_BY, problem -> stopped(action, problem.orElse(null)));
            case "stateRequest" -> actions.end(action.id(), Status.FINISHED, "");
            case "factsheetRequest" -> {
                publishFactsheet();
                actions.end(action.id(), Status.FINISHED, "");
            }
            case "stopPause" ->
                actions.end(action.id(), Status.FAILED, "nothing resumes by itself; a person sends the next command");
            default -> actions.end(action.id(), Status.FAILED, action.type() + " is not supported");
        }
    }

    private void stopped(InstantAction action, @Nullable String problem) {
        actions.end(action.id(), problem == null ? Status.FINISHED : Status.FAILED, problem == null ? "" : problem);
        publishState();
    }

    /** Publishes that the vehicle has gone offline, and disconnects. */
    @Override
    public void close() {
        closed = true;
        publish(header.connection("OFFLINE"));
        connection.close();
    }
}
