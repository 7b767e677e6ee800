package majicsim.ros.rosapi;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import java.util.function.Function;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.message.RosVersion;

/** The services of rosapi for parameters, whose values are JSON texts (sheet 5). */
final class ParameterServices {
    private final RosNetwork network;

    ParameterServices(RosNetwork network) {
        this.network = network;
    }

    /** Offers a service of rosapi. */
    interface Offer {
        void offer(String name, String type, Function<ObjectNode, ObjectNode> answer);
    }

    void offer(Offer node) {
        node.offer("get_param", "GetParam", this::get);
        node.offer("get_param_names", "GetParamNames", request -> names());
        node.offer(
                "has_param",
                "HasParam",
                request -> object().put("exists", parameters().containsKey(name(request))));
        node.offer("set_param", "SetParam", request -> {
            parameters().put(name(request), request.path("value").asText("null"));
            return object();
        });
        node.offer("delete_param", "DeleteParam", request -> {
            parameters().remove(name(request));
            return object();
        });
        if (network.types().version() == RosVersion.ROS1) {
            node.offer("search_param", "SearchParam", this::search);
        }
    }

    /** A missing parameter is the default if there is one, otherwise the text {@code null}. */
    private ObjectNode get(ObjectNode request) {
        String otherwise =
                request.path("default").asText(request.path("default_value").asText(""));
        return object().put(
                        "value", parameters().getOrDefault(name(request), otherwise.isEmpty() ? "null" : otherwise));
    }

    private ObjectNode names() {
        ObjectNode answer = object();
        ArrayNode names = answer.putArray("names");
        parameters().keySet().forEach(names::add);
        return answer;
    }

    /** The search goes up from the namespace of rosapi, which is the outermost one. */
    private ObjectNode search(ObjectNode request) {
        String name = network.absolute(name(request));
        return object().put("global_name", parameters().containsKey(name) ? name : "");
    }

    private Map<String, String> parameters() {
        return network.parameters();
    }

    private static String name(ObjectNode request) {
        return request.path("name").asText("");
    }

    private static ObjectNode object() {
        return JsonNodeFactory.instance.objectNode();
    }
}
