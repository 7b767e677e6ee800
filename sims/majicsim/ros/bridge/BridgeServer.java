package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majicsim.net.Line;
import majicsim.ros.graph.RosNetwork;
import majicsim.ros.graph.Topic;
import majicsim.ros.message.JsonForm;
import majicsim.ros.options.RosOptions;

/**
 * A rosbridge v2 server. Sends no pings and no status messages, and publishes nothing in the name of a client that has
 * disconnected. Guarded by the lab's lock.
 */
public final class BridgeServer {
    private static final long STEP_NANOS = 4_000_000;

    private final RosNetwork network;
    private final SharedParts shared;
    private final Map<Line, BridgeClient> clients = new LinkedHashMap<>();

    /** Clients whose connections ended while the server hung. */
    private final List<BridgeClient> left = new ArrayList<>();

    private final Topic clientCount;
    private final Topic connectedClients;

    /**
     * A server without clients.
     *
     * @param network the robot's network, in which it is a node
     * @param options its kind
     * @param faults ordered for it
     */
    public BridgeServer(RosNetwork network, RosOptions options, BridgeFaults faults) {
        this.network = network;
        JsonForm form = new JsonForm(options.version());
        this.shared = new SharedParts(
                network,
                options,
                faults,
                form,
                new Publishers(network),
                new Subscribers(network, form),
                new Goals(),
                this::publishClients);
        network.nodes().add(Peer.NODE);
        clientCount = network.advertise(Peer.NODE, "/client_count", "std_msgs/Int32");
        connectedClients = network.advertise(Peer.NODE, "/connected_clients", "rosbridge_msgs/ConnectedClients");
        publishClients();
    }

    /**
     * Begins a connection.
     *
     * @param line where the client is
     */
    public void connected(Line line) {
        clients.put(line, new BridgeClient(line, shared));
    }

    /**
     * Takes what a client sent.
     *
     * @param line where from
     * @param bytes in pieces of any size
     */
    public void received(Line line, byte[] bytes) {
        BridgeClient client = clients.get(line);
        if (client != null) {
            client.receive(bytes);
        }
    }

    /**
     * Ends a connection whose line has ended.
     *
     * @param line the line
     */
    public void disconnected(Line line) {
        BridgeClient client = clients.remove(line);
        if (client != null && shared.faults().isHanging()) {
            left.add(client);
        } else if (client != null) {
            client.end();
            publishClients();
        }
    }

    /**
     * Hangs, or goes on with what arrived meanwhile, as a process that is suspended. Of a connection that was closed
     * meanwhile only the first message is carried out and the others are lost, as with real servers. A fault.
     *
     * @param hangs whether it hangs from now on
     */
    public void hang(boolean hangs) {
        shared.faults().hang(hangs);
        if (!hangs) {
            List.copyOf(clients.values()).forEach(BridgeClient::goOn);
            left.forEach(BridgeClient::goOnWithFirst);
            left.forEach(BridgeClient::end);
            left.clear();
            publishClients();
        }
    }

    /** Lets time pass; the network's clock has just been advanced. */
    public void step() {
        shared.publishers().step();
        shared.subscribers().step();
        List.copyOf(clients.values()).forEach(BridgeClient::step);
    }

    /**
     * For how long nothing will change but the time.
     *
     * @return lab time, ns
     */
    public long restNanos() {
        if (!clients.values().stream().allMatch(BridgeClient::isIdle)) {
            return STEP_NANOS;
        }
        return Math.max(0, shared.subscribers().dueNanos() - network.clock().elapsedNanos());
    }

    /**
     * Closes all connections with a close frame. A fault.
     *
     * @param code of RFC 6455
     * @param reason for the clients' logs
     */
    public void closeAll(int code, String reason) {
        List.copyOf(clients.values()).forEach(client -> client.close(code, reason));
    }

    /**
     * Sends a huge message to all clients. A fault.
     *
     * @param bytes its size, 100 or more
     */
    public void sendHuge(int bytes) {
        clients.values().forEach(client -> client.sendHuge(bytes));
    }

    private void publishClients() {
        List<BridgeClient> open =
                clients.values().stream().filter(BridgeClient::isOpen).toList();
        ObjectNode count = JsonObjects.empty().put("data", open.size());
        ObjectNode all = JsonObjects.empty();
        ArrayNode list = all.putArray("clients");
        for (BridgeClient client : open) {
            list.addObject().put("ip_address", client.address()).put("connection_time", client.connectedNanos());
        }
        clientCount.latch(count);
        connectedClients.latch(all);
    }
}
