package majic.ros.graph;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.ServiceFailed;

/**
 * Asks the node rosapi of a robot (rosbridge sheet 5). Each question blocks for at most {@value #TIMEOUT_S} s.
 * Thread-safe.
 */
public final class RosApi {
    /** A service that is forbidden on the robot is not answered, so each call has a time limit, seconds. */
    static final double TIMEOUT_S = 5;

    private static final JsonMapper JSON = new JsonMapper();

    private static final String NODE = "/rosapi";

    private final RosBridge bridge;
    private final String namespace;
    private volatile String node;

    /**
     * Whether a question that can do without an answer had none: the others are not asked then, since waiting for each
     * of them would make a connection take minutes.
     */
    private volatile boolean isSilent;

    /**
     * Creates the client.
     *
     * @param bridge an open connection
     * @param namespace of the robot, as in its address, in which the node may be; empty if the address has none
     */
    public RosApi(RosBridge bridge, String namespace) {
        this(bridge, namespace, NODE);
    }

    private RosApi(RosBridge bridge, String namespace, String node) {
        this.bridge = bridge;
        this.namespace = namespace;
        this.node = node;
    }

    /**
     * Returns the client of the same node on another connection.
     *
     * @param other open
     * @return for the node that was found
     */
    public RosApi on(RosBridge other) {
        return new RosApi(other, namespace, node);
    }

    /**
     * Returns the name of the node.
     *
     * @return as found by {@link #graph}; {@code /rosapi} before
     */
    public String node() {
        return node;
    }

    /**
     * Reads the version, the topics and the nodes.
     *
     * @return what is there now
     * @throws ConnectFailed if rosapi does not answer, or the server does not let this program in; the message says
     *     what to do
     */
    public RosGraph graph() {
        Version version = version();
        JsonNode topics = required("topics");
        return new RosGraph(version.number(), version.distribution(), types(topics), nodes());
    }

    private record Version(int number, String distribution) {}

    /**
     * Only ROS 2 has a service for the version. The node is in the namespace of the server since version 2.2.0 of
     * rosbridge; without one before that, as in ROS 1.
     */
    private Version version() {
        for (String candidate : candidates()) {
            node = candidate;
            try {
                JsonNode answer = call("get_ros_version", empty());
                int number = answer.path("version").asInt(2);
                return new Version(number, clean(answer.path("distro").asText("")));
            } catch (ServiceFailed e) {
                if (!e.isAnswered()) {
                    throw silent(e);
                }
            } catch (LinkLost e) {
                throw new ConnectFailed(
                        Reason.NOT_ALLOWED,
                        "the rosbridge server closed the connection at the first request (" + e.getMessage()
                                + "); does it demand authentication? MAJIC has none; can the server be started with"
                                + " authenticate:=false?",
                        e);
            }
        }
        node = NODE;
        return new Version(1, parameter("/rosdistro").orElse(""));
    }

    private List<String> candidates() {
        List<String> candidates = new ArrayList<>(List.of(NODE));
        for (String inner = namespace; !inner.isEmpty(); inner = inner.substring(0, inner.lastIndexOf('/'))) {
            candidates.add(inner + NODE);
        }
        return candidates;
    }

    private JsonNode call(String question, ObjectNode arguments) {
        return bridge.call(node + "/" + question, arguments, TIMEOUT_S);
    }

    private JsonNode required(String question) {
        try {
            return call(question, empty());
        } catch (ServiceFailed e) {
            throw silent(e);
        }
    }

    private static ConnectFailed silent(ServiceFailed cause) {
        return new ConnectFailed(
                Reason.NO_ANSWER,
                "the rosbridge server is there, but its node rosapi is not, which lists the topics ("
                        + cause.getMessage()
                        + "); were both started by the launch file rosbridge_websocket of the package rosbridge_server?"
                        + " If they run in a namespace, it belongs behind the address, as in ros://HOST/NAMESPACE",
                cause);
    }

    private static Map<String, String> types(JsonNode answer) {
        Map<String, String> types = new TreeMap<>();
        JsonNode names = answer.path("topics");
        for (int i = 0; i < names.size(); i++) {
            types.put(names.path(i).asText(), answer.path("types").path(i).asText());
        }
        return types;
    }

    private TreeSet<String> nodes() {
        return new TreeSet<>(names("nodes", empty(), "nodes").orElse(List.of()));
    }

    /**
     * Returns the nodes that receive a topic.
     *
     * @param topic its absolute name
     * @return without the rosbridge server; empty if rosapi does not answer
     */
    public Optional<List<String>> subscribers(String topic) {
        return names("subscribers", empty().put("topic", topic), "subscribers")
                .map(nodes -> nodes.stream().filter(node -> !isBridge(node)).toList());
    }

    private static boolean isBridge(String node) {
        return node.contains("rosbridge");
    }

    private Optional<List<String>> names(String question, ObjectNode arguments, String field) {
        return asked(question, arguments).map(values -> {
            List<String> names = new ArrayList<>();
            values.path(field).forEach(name -> names.add(name.asText()));
            return names;
        });
    }

    /** Asks a question that can do without an answer. */
    private Optional<JsonNode> asked(String question, ObjectNode arguments) {
        if (isSilent) {
            return Optional.empty();
        }
        try {
            return Optional.of(call(question, arguments));
        } catch (ServiceFailed e) {
            isSilent = !e.isAnswered();
            return Optional.empty();
        }
    }

    /**
     * Reads a parameter.
     *
     * @param name as {@code /tb3_model} in ROS 1, {@code /turtlebot3_node:wheels.separation} in ROS 2
     * @return its value as text, a string without quotes; empty if there is none
     */
    public Optional<String> parameter(String name) {
        return asked("get_param", empty().put("name", name))
                .map(values -> values.path("value").asText(""))
                .filter(json -> !json.isBlank() && !json.equals("null"))
                .map(RosApi::clean);
    }

    /**
     * Reads a parameter that is a text.
     *
     * @param name as {@link #parameter} takes it
     * @return the text unchanged; empty if there is none, or it is no text
     */
    public Optional<String> textParameter(String name) {
        return asked("get_param", empty().put("name", name))
                .map(values -> values.path("value").asText(""))
                .flatMap(RosApi::textOf);
    }

    private static Optional<String> textOf(String json) {
        try {
            return Optional.ofNullable(JSON.readTree(json).textValue());
        } catch (JsonProcessingException e) {
            return Optional.empty();
        }
    }

    /** Values are JSON texts; that of the distribution may end with a line break inside of its quotes. */
    private static String clean(String json) {
        return json.replace("\\n", " ").replace("\"", "").strip().toLowerCase(Locale.ROOT);
    }

    private static ObjectNode empty() {
        return JsonNodeFactory.instance.objectNode();
    }
}
