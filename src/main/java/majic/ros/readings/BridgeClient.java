package majic.ros.readings;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
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
    private final Supplier<RosBridge> opener;
    private final boolean ros2;
    private final String namespace;
    private final Set<String> advertised = ConcurrentHashMap.newKeySet();
    private volatile Map<String, String> topics;

    /**
     * Wraps open connections; closes neither.
     *
     * @param driving for topics
     * @param services for calls; may be the same on ROS 1
     * @param opener opens a further connection, for a goal
     * @param ros2 whether the robot runs ROS 2
     * @param namespace of the robot, such as {@code /robot1}; empty for a robot without
     * @param topics the types of all topics by their names
     */
    public BridgeClient(
            RosBridge driving,
            RosBridge services,
            Supplier<RosBridge> opener,
            boolean ros2,
            String namespace,
            Map<String, String> topics) {
        this.driving = driving;
        this.services = services;
        this.opener = opener;
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
        JsonNode listed = call("/rosapi/topics", JsonNodeFactory.instance.objectNode(), LIST_S);
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
        RosBridge own = opener.get();
        return new BridgeCall(own, own::close, changed);
    }

    @Override
    public GoalChannel openGoal() {
        return new BridgeGoal(opener.get(), services);
    }
}
