package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicSubscription;

/**
 * The connection with a robot through a rosbridge server. Calls have a connection of their own, and each goal one more,
 * because servers for ROS 2 up to 2.1.0 handle nothing else on a connection until a call or a goal is finished.
 */
public final class BridgeClient implements RosClient {
    private static final double LIST_S = 5;

    private final RosBridge driving;
    private final RosBridge services;
    private final Connections connections;
    private final String rosapi;
    private final boolean ros2;
    private final String namespace;
    private final Set<String> advertised = ConcurrentHashMap.newKeySet();
    private volatile Map<String, String> topics;

    /** The connections with the server. */
    public interface Connections {
        /** The one for velocities and what is needed for motion and stop. */
        RosBridge drive();

        /** The one for calls; the same on ROS 1. */
        RosBridge services();

        /**
         * Opens a further one, for a goal or a long call.
         *
         * @throws BotException if the server does not accept it
         */
        RosBridge openFurther();

        /** The one for sensors. */
        TopicSource sensors();

        /** The one for what may be large. */
        TopicSource large();
    }

    /**
     * Wraps open connections; closes none.
     *
     * @param connections with the server
     * @param rosapi the name of the node rosapi, as {@code /rosapi}
     * @param ros2 whether the robot runs ROS 2
     * @param namespace of the robot, such as {@code /robot1}; empty for a robot without
     * @param topics the types of all topics by their names
     */
    public BridgeClient(
            Connections connections, String rosapi, boolean ros2, String namespace, Map<String, String> topics) {
        this.connections = connections;
        this.driving = connections.drive();
        this.services = connections.services();
        this.rosapi = rosapi;
        this.ros2 = ros2;
        this.namespace = namespace;
        this.topics = Map.copyOf(topics);
    }

    @Override
    public boolean isRos2() {
        return ros2;
    }

    @Override
    public String namespace() {
        return namespace;
    }

    @Override
    public Map<String, String> topics() {
        return topics;
    }

    @Override
    public Map<String, String> listTopics() {
        JsonNode listed = ask("topics", JsonNodeFactory.instance.objectNode(), LIST_S);
        Map<String, String> found = new LinkedHashMap<>();
        for (int index = 0; index < listed.path("topics").size(); index++) {
            found.put(
                    listed.path("topics").path(index).asText(""),
                    listed.path("types").path(index).asText(""));
        }
        topics = Map.copyOf(found);
        return topics;
    }

    @Override
    public Runnable subscribe(TopicSubscription wanted, Consumer<JsonNode> onMessage) {
        return driving.subscribe(wanted, onMessage)::close;
    }

    @Override
    public TopicSource sensors() {
        return connections.sensors();
    }

    @Override
    public TopicSource large() {
        return connections.large();
    }

    @Override
    public JsonNode ask(String question, JsonNode arguments, double timeoutS) {
        return call(rosapi + "/" + question, arguments, timeoutS);
    }

    @Override
    public JsonNode call(String service, JsonNode arguments, double timeoutS) {
        return services.call(service, arguments, timeoutS);
    }

    @Override
    public void request(String service, JsonNode arguments) {
        services.request(service, arguments);
    }

    @Override
    public void publish(String topic, String type, JsonNode message) {
        if (advertised.add(topic)) {
            driving.advertise(topic, type);
        }
        driving.publish(topic, message);
    }

    @Override
    public CallChannel openCall(Runnable changed) {
        if (!ros2) {
            return new BridgeCall(services, () -> {}, changed);
        }
        RosBridge own = connections.openFurther();
        return new BridgeCall(own, own::close, changed);
    }

    @Override
    public GoalChannel openGoal() {
        return new BridgeGoal(connections.openFurther(), services);
    }
}
