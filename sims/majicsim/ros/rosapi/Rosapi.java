package majicsim.ros.rosapi;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Service;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.RosVersion;

/** The node rosapi of one network. It answers at once. */
public final class Rosapi {
    private static final String NAME = "/rosapi";
    private static final int ROS2 = 2;

    /** The name of the robot's computer. */
    private static final String HOST = "turtlebot";

    private final RosNetwork network;
    private final String node;
    private final MessageDetails details;

    private Rosapi(RosNetwork network) {
        this.network = network;
        this.node = network.serverNamespace() + NAME;
        this.details = new MessageDetails(network.types());
    }

    /**
     * Starts the node.
     *
     * @param network the network that it describes and belongs to
     * @param distribution name of the version of ROS, as {@code noetic}
     */
    public static void start(RosNetwork network, String distribution) {
        Rosapi rosapi = new Rosapi(network);
        network.nodes().add(rosapi.node);
        rosapi.offerTopics();
        rosapi.offerNodes();
        rosapi.offerServices();
        rosapi.offerDetails();
        new ParameterServices(network).offer(rosapi::offer);
        rosapi.offer(
                "get_time",
                "GetTime",
                request -> object().put("time", network.clock().nanos()));
        if (network.types().version() == RosVersion.ROS2) {
            rosapi.offer(
                    "get_ros_version",
                    "GetROSVersion",
                    request -> object().put("version", ROS2).put("distro", distribution));
        }
    }

    private void offer(String name, String type, Function<ObjectNode, ObjectNode> answer) {
        network.offer(
                node, node + "/" + name, "rosapi/" + type, (request, reply) -> reply.succeed(answer.apply(request)));
    }

    private void offerTopics() {
        offer("topics", "Topics", request -> {
            List<Topic> all = network.topics().all();
            return list("topics", all.stream().map(Topic::name).toList())
                    .setAll(list(
                            "types",
                            all.stream().map(topic -> topic.type().fullName()).toList()));
        });
        offer(
                "topics_for_type",
                "TopicsForType",
                request -> list(
                        "topics",
                        network.topics().all().stream()
                                .filter(topic -> topic.type().fullName().equals(text(request, "type")))
                                .map(Topic::name)
                                .toList()));
        offer("topic_type", "TopicType", request -> {
            Topic topic = network.topics().find(text(request, "topic"));
            return object().put("type", topic == null ? "" : topic.type().fullName());
        });
        offer("publishers", "Publishers", request -> {
            Topic topic = network.topics().find(text(request, "topic"));
            return list("publishers", topic == null ? List.of() : topic.publishers());
        });
        offer("subscribers", "Subscribers", request -> {
            Topic topic = network.topics().find(text(request, "topic"));
            return list("subscribers", topic == null ? List.of() : topic.subscribers());
        });
    }

    private void offerNodes() {
        offer("nodes", "Nodes", request -> list("nodes", network.nodes()));
        offer("node_details", "NodeDetails", request -> {
            String node = text(request, "node");
            List<Topic> all = network.topics().all();
            ObjectNode details = list(
                    "subscribing",
                    all.stream()
                            .filter(topic -> topic.subscribers().contains(node))
                            .map(Topic::name)
                            .toList());
            details.setAll(list(
                    "publishing",
                    all.stream()
                            .filter(topic -> topic.publishers().contains(node))
                            .map(Topic::name)
                            .toList()));
            return details.setAll(list(
                    "services",
                    network.services().values().stream()
                            .filter(service -> service.node().equals(node))
                            .map(Service::name)
                            .toList()));
        });
        offer("action_servers", "GetActionServers", request -> list("action_servers", actionServers()));
    }

    /** On ROS 1 an action is recognised by its topics. */
    private List<String> actionServers() {
        if (network.types().version() == RosVersion.ROS2) {
            return List.copyOf(network.actions().keySet());
        }
        return network.topics().all().stream()
                .map(Topic::name)
                .filter(name -> name.endsWith("/result"))
                .map(name -> name.substring(0, name.length() - "/result".length()))
                .toList();
    }

    private void offerServices() {
        offer(
                "services",
                "Services",
                request -> list("services", network.services().keySet()));
        offer("service_type", "ServiceType", request -> {
            Service service = network.service(text(request, "service"));
            return object().put("type", service == null ? "" : service.typeName());
        });
        offer("service_node", "ServiceNode", request -> {
            Service service = network.service(text(request, "service"));
            return object().put("node", service == null ? "" : service.node());
        });
        offer(
                "service_providers",
                "ServiceProviders",
                request -> list(
                        "providers",
                        network.services().values().stream()
                                .filter(service -> service.typeName().equals(text(request, "service")))
                                .map(Service::node)
                                .toList()));
        if (network.types().version() == RosVersion.ROS1) {
            offer(
                    "service_host",
                    "ServiceHost",
                    request -> object().put("host", network.service(text(request, "service")) == null ? "" : HOST));
        }
        offer(
                "services_for_type",
                "ServicesForType",
                request -> list(
                        "services",
                        network.services().entrySet().stream()
                                .filter(entry -> entry.getValue().typeName().equals(text(request, "type")))
                                .map(Map.Entry::getKey)
                                .toList()));
    }

    private void offerDetails() {
        offer("topics_and_raw_types", "TopicsAndRawTypes", request -> {
            List<Topic> all = network.topics().all();
            ObjectNode answer = list("topics", all.stream().map(Topic::name).toList());
            answer.setAll(list(
                    "types", all.stream().map(topic -> topic.type().fullName()).toList()));
            return answer.setAll(list(
                    "typedefs_full_text",
                    all.stream().map(topic -> details.text(topic.type())).toList()));
        });
        offer("message_details", "MessageDetails", details::ofMessage);
        offer("service_request_details", "ServiceRequestDetails", request -> details.ofService(request, "Request"));
        offer("service_response_details", "ServiceResponseDetails", request -> details.ofService(request, "Response"));
    }

    private static String text(ObjectNode request, String field) {
        return request.path(field).asText("");
    }

    private static ObjectNode object() {
        return JsonNodeFactory.instance.objectNode();
    }

    private static ObjectNode list(String field, Collection<String> texts) {
        ObjectNode object = object();
        ArrayNode array = object.putArray(field);
        texts.forEach(array::add);
        return object;
    }
}
