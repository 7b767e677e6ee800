package majicsim.ros.graph;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import majicsim.ros.message.MessageTypes;
import org.jspecify.annotations.Nullable;

/** Everything that the nodes of one computer share. Guarded by the lab's lock. */
public final class RosNetwork {
    private final MessageTypes types;
    private final String serverNamespace;
    private final RosClock clock = new RosClock();
    private final Topics topics = new Topics();
    private final Set<String> nodes = new LinkedHashSet<>();
    private final Map<String, Service> services = new LinkedHashMap<>();
    private final Map<String, ActionServer> actions = new LinkedHashMap<>();
    private final Map<String, String> parameters = new LinkedHashMap<>();

    /**
     * A network without nodes.
     *
     * @param types the message types of its version of ROS
     * @param serverNamespace of the nodes of rosbridge, as {@code /tb3}; empty for none
     */
    public RosNetwork(MessageTypes types, String serverNamespace) {
        this.types = types;
        this.serverNamespace = serverNamespace;
    }

    /**
     * The name of a topic or service for a client of rosbridge, whose node completes relative names.
     *
     * @param name absolute, or relative to the namespace of the node
     * @return absolute
     */
    public String absolute(String name) {
        return name.startsWith("/") ? name : serverNamespace + "/" + name;
    }

    /**
     * The namespace of the nodes of rosbridge.
     *
     * @return as {@code /tb3}; empty for none
     */
    public String serverNamespace() {
        return serverNamespace;
    }

    /**
     * The message types.
     *
     * @return as they were given
     */
    public MessageTypes types() {
        return types;
    }

    /**
     * The clock of the computer.
     *
     * @return the same at every call
     */
    public RosClock clock() {
        return clock;
    }

    /**
     * The topics.
     *
     * @return the same at every call
     */
    public Topics topics() {
        return topics;
    }

    /**
     * The names of the nodes, in the order of their start.
     *
     * @return changeable
     */
    public Set<String> nodes() {
        return nodes;
    }

    /**
     * The services by name.
     *
     * @return changeable
     */
    public Map<String, Service> services() {
        return services;
    }

    /**
     * The action servers by name; none on ROS 1, whose actions are topics.
     *
     * @return changeable
     */
    public Map<String, ActionServer> actions() {
        return actions;
    }

    /**
     * The parameters by name.
     *
     * @return JSON texts; changeable
     */
    public Map<String, String> parameters() {
        return parameters;
    }

    /**
     * Makes a publisher of a node.
     *
     * @param node its name
     * @param topic absolute name of the topic
     * @param plainType the topic's type
     * @return the topic
     */
    public Topic advertise(String node, String topic, String plainType) {
        Topic made = topics.at(topic, types.get(plainType));
        made.addPublisher(node);
        return made;
    }

    /**
     * Makes a subscriber of a node.
     *
     * @param node its name
     * @param topic absolute name of the topic
     * @param plainType the topic's type
     * @param listener receives the messages
     */
    public void subscribe(String node, String topic, String plainType, TopicListener listener) {
        topics.at(topic, types.get(plainType)).subscribe(node, listener);
    }

    /**
     * Offers a service of a type whose request and response are in the table of types.
     *
     * @param node its name
     * @param name of the service, absolute
     * @param plainType package and name of the service's type
     * @param handler carries it out
     */
    public void offer(String node, String name, String plainType, Service.Handler handler) {
        String typeName = types.version().serviceName(plainType);
        services.put(
                name,
                new Service(
                        name,
                        node,
                        typeName,
                        types.get(plainType + "Request"),
                        types.get(plainType + "Response"),
                        handler));
    }

    /**
     * A service that exists.
     *
     * @param name absolute
     * @return null if there is none
     */
    public @Nullable Service service(String name) {
        return services.get(name);
    }
}
