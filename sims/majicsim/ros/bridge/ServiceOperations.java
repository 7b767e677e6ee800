package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Objects;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Service;
import majicsim.ros.graph.ServiceReply;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageInput;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.MessageOutput;
import org.jspecify.annotations.Nullable;

/** call_service of one client (sheet 3). */
final class ServiceOperations {
    private final Peer peer;
    private final RosNetwork network;
    private final MessageInput input;
    private final MessageOutput output;
    private final BridgeFaults faults;

    ServiceOperations(Peer peer, RosNetwork network, MessageInput input, BridgeFaults faults) {
        this.peer = peer;
        this.network = network;
        this.input = input;
        this.output = new MessageOutput(network.types());
        this.faults = faults;
    }

    void call(JsonNode message) throws MessageMismatch {
        String name = Fields.text(message, "service");
        int fragmentSize = Fields.number(message, "fragment_size", 0);
        if (fragmentSize > 0) {
            peer.fragmentSize(fragmentSize);
        }
        peer.hold(true);
        if (!faults.isWithoutServices()) {
            call(name, message.path("args"), new Reply(name, message.path("id")));
        }
    }

    private void call(String name, JsonNode args, Reply reply) {
        Service service = network.service(network.absolute(name));
        if (service == null) {
            reply.fail("Service " + network.absolute(name) + " does not exist");
            return;
        }
        reply.service = service;
        try {
            ObjectNode request = input.checked(service.request(), byName(service, args));
            service.handler().call(request, reply);
        } catch (MessageMismatch e) {
            reply.fail(e.getMessage());
        }
    }

    /** Arguments come by name, or in the order of the fields; anything else counts as none. */
    private static JsonNode byName(Service service, JsonNode args) {
        if (args.isArray()) {
            return service.request().named(args);
        }
        return args.isObject() ? args : JsonObjects.empty();
    }

    /** Sends the outcome of one call; until then it holds up the connection where the bridge does so. */
    private final class Reply implements ServiceReply {
        private final String name;
        private final JsonNode id;
        private @Nullable Service service;

        Reply(String name, JsonNode id) {
            this.name = name;
            this.id = id;
        }

        @Override
        public void succeed(ObjectNode response) {
            Service called = Objects.requireNonNull(service);
            send(to -> output.write(to, called.response(), response), true);
        }

        @Override
        public void fail(String reason) {
            send(to -> to.writeString(reason), false);
        }

        private void send(JsonForm.Content values, boolean succeeded) {
            peer.send(id, to -> {
                to.writeStartObject();
                to.writeStringField("op", "service_response");
                to.writeStringField("service", name);
                to.writeFieldName("values");
                values.write(to);
                to.writeBooleanField("result", succeeded);
                JsonObjects.writeId(to, id);
                to.writeEndObject();
            });
            peer.hold(false);
        }
    }
}
