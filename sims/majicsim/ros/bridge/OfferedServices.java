package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Service;
import majicsim.ros.graph.ServiceReply;
import majicsim.ros.message.MessageInput;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.MessageOutput;

/** The services that one client offers: advertise_service, unadvertise_service and service_response (sheet 3). */
final class OfferedServices {
    private static final String SERVICE = "service";

    private final Peer peer;
    private final RosNetwork network;
    private final MessageInput input;
    private final MessageOutput output;
    private final Set<String> offered = new HashSet<>();
    private final Map<String, Pending> pending = new HashMap<>();
    private int count;

    OfferedServices(Peer peer, RosNetwork network, MessageInput input) {
        this.peer = peer;
        this.network = network;
        this.input = input;
        this.output = new MessageOutput(network.types());
    }

    void advertise(JsonNode message) throws MessageMismatch {
        String name = network.absolute(Fields.text(message, SERVICE));
        String plain = Fields.text(message, "type").replaceFirst("/srv/", "/");
        if (network.types().find(plain + "Request").isEmpty()) {
            throw new MessageMismatch(plain + " is not a known service");
        }
        network.offer(Peer.NODE, name, plain, (request, reply) -> ask(name, request, reply));
        offered.add(name);
    }

    void unadvertise(JsonNode message) throws MessageMismatch {
        String name = network.absolute(Fields.text(message, SERVICE));
        if (offered.remove(name)) {
            network.services().remove(name);
        }
    }

    void respond(JsonNode message) throws MessageMismatch {
        Pending call = pending.remove(Fields.id(message));
        if (call == null) {
            throw new MessageMismatch("no call of a service has this id");
        }
        if (message.path("result").asBoolean()) {
            call.reply().succeed(input.checked(call.service().response(), message.path("values")));
        } else {
            call.reply().fail(message.path("values").asText());
        }
    }

    void end() {
        offered.forEach(network.services()::remove);
        pending.values()
                .forEach(call -> call.reply().fail("Service " + call.service().name() + " is gone"));
        pending.clear();
    }

    private void ask(String name, ObjectNode request, ServiceReply reply) {
        Service service = network.services().get(name);
        count++;
        String id = "service_request:" + name + ":" + count;
        pending.put(id, new Pending(service, reply));
        peer.send(null, to -> {
            to.writeStartObject();
            to.writeStringField("op", "call_service");
            to.writeStringField("id", id);
            to.writeStringField(SERVICE, name);
            to.writeFieldName("args");
            output.write(to, service.request(), request);
            to.writeEndObject();
        });
    }

    private record Pending(Service service, ServiceReply reply) {}
}
