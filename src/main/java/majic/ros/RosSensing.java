package majic.ros;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.driver.RobotWait;
import majic.ros.bridge.ServiceFailed;
import majic.ros.message.Hazard;
import majic.ros.message.OdometryMessage;
import majic.ros.navigation.Navigation;
import majic.ros.navigation.NavigationServers;
import majic.ros.parameters.RosAccess;
import majic.ros.parameters.RosParameters;
import majic.ros.readings.ActiveHazards;
import majic.ros.readings.BridgeClient;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;
import majic.ros.readings.RosTopic;
import majic.velocity.Obstruction;
import majic.velocity.Obstruction.Side;
import majic.velocity.ObstructionSource;
import org.jspecify.annotations.Nullable;

/** What a robot has beside its wheels: sensors, services and goals, with their parameters and commands. Thread-safe. */
final class RosSensing implements ObstructionSource {
    private static final double ASK_S = 3;

    /** A scanner that sends once a second is slow. A sensor that sends nothing is no reason not to connect. */
    private static final double FIRST_READINGS_S = 1.5;

    private final RobotWait waiting;
    private final RosReadings.Events events;
    private final Navigation navigation;
    private final RosParameters parameters;
    private volatile @Nullable RosReadings readings;
    private volatile NavigationServers servers = NavigationServers.NONE;

    /**
     * Describes a robot without sensors.
     *
     * @param table lists the parameters
     * @param waiting the robot's clock and signal
     * @param radiusMm of the robot
     * @param state the newest state of the robot
     * @param events handles what arrives
     */
    RosSensing(
            ParameterTable table,
            RobotWait waiting,
            DoubleSupplier radiusMm,
            Supplier<BotState> state,
            RosReadings.Events events) {
        this.waiting = waiting;
        this.events = events;
        this.navigation = new Navigation(waiting.changes());
        this.parameters =
                new RosParameters(table, new RosAccess(() -> readings), navigation, waiting.changes(), radiusMm, state);
    }

    /** Subscribes to the sensors of a robot that was found, and describes its parameters. */
    void begin(RosSession session) {
        String namespace = session.base().namespace();
        RosConnections connections = session.connections();
        BridgeClient client = new BridgeClient(
                connections,
                session.rosapi(),
                session.graph().isRos2(),
                namespace,
                session.graph().topics());
        Map<String, String> topics = ownTopics(session);
        RosSensors sensors = sensors(RosSensors.of(topics, namespace), session.camera());
        if (sensors.joints().isPresent()) {
            sensors = sensors.withSlidingJoints(session.slidingJoints());
        }
        List<String> actions = actions(client).stream()
                .filter(action -> !session.others().have(action))
                .toList();
        servers = NavigationServers.of(topics, actions, namespace);
        navigation.begin(client, servers);
        RosReadings opened = new RosReadings(client, sensors, waiting, events);
        readings = opened;
        parameters.describe(sensors, servers);
        opened.begin();
    }

    /** The topics without those of other robots. */
    private static Map<String, String> ownTopics(RosSession session) {
        Map<String, String> own = new TreeMap<>(session.graph().topics());
        own.keySet().removeIf(session.others()::have);
        return own;
    }

    private static RosSensors sensors(RosSensors found, @Nullable String camera) {
        if (camera == null) {
            return found;
        }
        return found.withCamera(camera).orElseThrow(() -> {
            String names = found.cameras().stream().map(RosTopic::name).collect(Collectors.joining(" or "));
            return new ConnectFailed(
                    Reason.OTHER,
                    "the robot has no camera " + camera + ", which is a topic of the type CompressedImage"
                            + (names.isEmpty() ? "; it has none at all" : "; is it " + names + "?"));
        });
    }

    /** Waits until the distances are known, so that a script can begin with them. */
    void awaitFirst() {
        RosReadings open = readings;
        if (open != null) {
            waiting.awaitConnecting(open::hasDistances, FIRST_READINGS_S);
        }
    }

    /**
     * Asks for the servers of actions, which are not among the topics of ROS 2. Older versions of rosapi have no list.
     */
    private static List<String> actions(BridgeClient client) {
        List<String> actions = new ArrayList<>();
        if (client.isRos2()) {
            try {
                JsonNode listed = client.ask("action_servers", JsonNodeFactory.instance.objectNode(), ASK_S);
                listed.path("action_servers").forEach(action -> actions.add(action.asText()));
            } catch (ServiceFailed e) {
                System.getLogger(RosSensing.class.getName())
                        .log(System.Logger.Level.DEBUG, "the servers of actions are not known", e);
            }
        }
        return actions;
    }

    /** The commands of the robot that was found last. */
    List<DriverCommand> commands() {
        return parameters.commands(servers);
    }

    /** Names the camera that is shown, and the others, if there are several; empty otherwise. */
    Optional<String> cameraNotice() {
        RosReadings open = readings;
        List<RosTopic> cameras = open == null ? List.of() : open.sensors().cameras();
        if (cameras.size() < 2) {
            return Optional.empty();
        }
        String others = cameras.stream().skip(1).map(RosTopic::name).collect(Collectors.joining(", "));
        return Optional.of("its camera is " + cameras.get(0).name() + "; there are also " + others
                + ", one of which is chosen by ?camera=TOPIC behind its address");
    }

    /** Takes a message of the odometry. */
    void odometry(OdometryMessage newest) {
        RosReadings open = readings;
        if (open != null) {
            open.odometry(newest);
        }
    }

    /** Cancels what the robot pursues by itself; waits for nothing. */
    void halt() {
        navigation.cancel();
    }

    /** Ends the subscriptions that nothing reads. Called about once a second. */
    void endUnused() {
        RosReadings open = readings;
        if (open != null) {
            open.endUnused();
        }
    }

    /** The readings of the newest connection; null before the first one. */
    @Nullable
    RosReadings readings() {
        return readings;
    }

    @Override
    public @Nullable Obstruction newest() {
        RosReadings open = readings;
        if (open == null) {
            return null;
        }
        boolean reflex = open.sensors().hazards().isPresent();
        return open.hazards()
                .last()
                .map(report -> new Obstruction(words(report), side(report), reflex, report.atNanos()))
                .orElse(null);
    }

    /** As the reason why a motion ended. */
    private static String words(ActiveHazards.Report report) {
        return report.hazard() == Hazard.BUMP
                        && List.of("front", "back", "left", "right", "centre").contains(report.place())
                ? report.place() + " bumper pressed"
                : report.words();
    }

    private static Side side(ActiveHazards.Report report) {
        boolean behind = report.place().contains("back") || report.place().contains("rear");
        return switch (report.hazard()) {
            case BACKUP_LIMIT -> Side.REAR;
            case BUMP, CLIFF, PROXIMITY -> behind ? Side.REAR : Side.FRONT;
            case STALL, WHEEL_DROP, OTHER -> Side.ALL;
        };
    }
}
