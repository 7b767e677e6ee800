package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import majicsim.net.Line;
import majicsim.ros.message.JsonForm;
import majicsim.ros.message.MessageInput;
import majicsim.ros.message.MessageMismatch;
import majicsim.ros.message.RosVersion;
import majicsim.ros.websocket.CloseCode;
import majicsim.ros.websocket.MessageListener;
import majicsim.ros.websocket.Paths;
import majicsim.ros.websocket.WebSocketEnd;
import org.jspecify.annotations.Nullable;

/** One client of the bridge: takes its messages one after the other and carries out their operations. */
final class BridgeClient implements Peer, MessageListener {
    private static final System.Logger LOG = System.getLogger(BridgeClient.class.getName());

    /** ROS 1 has no limit; so much is enough to show it. ROS 2 has 10 000 000 (sheet 2). */
    private static final long MOST_BYTES_ROS1 = 128L << 20;

    private static final long MOST_BYTES_ROS2 = 10_000_000;

    private static final String HUGE_HEAD = "{\"op\":\"publish\",\"topic\":\"/odom\",\"msg\":{\"child_frame_id\":\"";
    private static final String HUGE_TAIL = "\"}}";

    private final SharedParts shared;
    private final String address;
    private final long connectedNanos;
    private final WebSocketEnd socket;
    private final Outbox outbox;
    private final InputBuffer buffer;
    private final Authentication authentication;
    private final Fragments fragments = new Fragments();
    private final PublishOperations publishing;
    private final OfferedServices offered;
    private final Map<String, Operation> operations = new HashMap<>();
    private final ArrayDeque<JsonNode> inbox = new ArrayDeque<>();
    private final ByteArrayOutputStream held = new ByteArrayOutputStream();
    private int holds;
    private boolean isInputDead;
    private boolean isBusy;
    private boolean isGone;

    BridgeClient(Line line, SharedParts shared) {
        boolean isRos1 = shared.version() == RosVersion.ROS1;
        this.shared = shared;
        this.address = line.peer().replaceFirst(":\\d+$", "");
        this.connectedNanos = shared.network().clock().nanos();
        this.socket = new WebSocketEnd(
                line, isRos1 ? Paths.ANY : Paths.ROOT, isRos1 ? MOST_BYTES_ROS1 : MOST_BYTES_ROS2, this);
        this.outbox = new Outbox(socket);
        this.buffer = new InputBuffer(shared.form().reader());
        this.authentication = new Authentication(shared.options().secret());
        MessageInput input =
                new MessageInput(shared.network().types(), shared.network().clock()::nanos);
        this.publishing = new PublishOperations(shared.network(), shared.publishers(), input);
        this.offered = new OfferedServices(this, shared.network(), input);
        addOperations(input);
        if (!isRos1) {
            ActionOperations actions = new ActionOperations(this, shared.network(), input, shared.goals());
            operations.put("send_action_goal", actions::send);
            operations.put("cancel_action_goal", actions::cancel);
        }
    }

    private void addOperations(MessageInput input) {
        ServiceOperations services = new ServiceOperations(this, shared.network(), input, shared.faults());
        operations.put("advertise", publishing::advertise);
        operations.put("unadvertise", publishing::unadvertise);
        operations.put("publish", publishing::publish);
        operations.put("subscribe", message -> shared.subscribers().subscribe(this, message));
        operations.put("unsubscribe", message -> shared.subscribers().unsubscribe(this, message));
        operations.put("call_service", services::call);
        operations.put("advertise_service", offered::advertise);
        operations.put("unadvertise_service", offered::unadvertise);
        operations.put("service_response", offered::respond);
        operations.put("fragment", this::takeFragment);
    }

    String address() {
        return address;
    }

    long connectedNanos() {
        return connectedNanos;
    }

    boolean isOpen() {
        return socket.isOpen();
    }

    void receive(byte[] bytes) {
        if (shared.faults().isHanging()) {
            held.writeBytes(bytes);
            return;
        }
        socket.answerPings(!shared.faults().isWithoutPongs());
        socket.receive(bytes);
    }

    /** Takes what arrived while the server hung. */
    void goOn() {
        byte[] bytes = held.toByteArray();
        held.reset();
        receive(bytes);
    }

    /**
     * The same for a connection that has ended: its first message is already being carried out, the others are dropped.
     */
    void goOnWithFirst() {
        isGone = true;
        goOn();
        if (!inbox.isEmpty()) {
            carryOut(inbox.remove());
        }
        inbox.clear();
    }

    void step() {
        outbox.step();
    }

    boolean isIdle() {
        return outbox.isEmpty();
    }

    void close(int code, String reason) {
        socket.close(code, reason);
    }

    /**
     * The line has ended. The publishers remain for a while; nothing is published in the client's name (sheet 1, rule
     * 2).
     */
    void end() {
        shared.subscribers().end(this);
        publishing.end();
        offered.end();
    }

    @Override
    public void opened() {
        shared.clientsChanged().run();
    }

    @Override
    public void received(byte[] payload, boolean isText) {
        arrived(new String(payload, StandardCharsets.UTF_8));
    }

    @Override
    public void arrived(String text) {
        if (!isInputDead) {
            inbox.addAll(buffer.take(text));
            carryOutAll();
        }
    }

    /** A reply at once calls this again by {@link #hold}; the outer call then goes on. */
    private void carryOutAll() {
        if (isBusy || isGone) {
            return;
        }
        isBusy = true;
        while (!inbox.isEmpty() && holds == 0 && !isInputDead && socket.isOpen()) {
            carryOut(inbox.remove());
        }
        isBusy = false;
    }

    private void carryOut(JsonNode message) {
        if (message.isArray() || message.isNull()) {
            return;
        }
        if (!message.isObject() || (message.has("png") && !message.has("msg"))) {
            isInputDead = true;
            LOG.log(Level.DEBUG, "the input of {0} has ended by {1}", address, message);
        } else if (!authentication.isPassed()) {
            if (!authentication.check(message)) {
                socket.close(CloseCode.NORMAL, "");
            }
        } else {
            carryOutOperation(message);
        }
    }

    private void carryOutOperation(JsonNode message) {
        Operation operation = operations.get(message.path("op").asText());
        try {
            if (operation == null) {
                throw new MessageMismatch("unknown operation " + message.path("op"));
            }
            int size = Fields.number(message, "fragment_size", 0);
            if (size > 0) {
                fragments.size(size);
            }
            operation.carryOut(message);
        } catch (MessageMismatch e) {
            LOG.log(Level.DEBUG, "dropped: {0}", e.getMessage());
        }
    }

    private void takeFragment(JsonNode message) throws MessageMismatch {
        String whole = fragments.take(message);
        if (whole != null) {
            arrived(whole);
        }
    }

    @Override
    public void fragmentSize(int characters) {
        fragments.size(characters);
    }

    @Override
    public void hold(boolean begins) {
        if (shared.options().blocksConnection()) {
            holds += begins ? 1 : -1;
            if (!begins && holds == 0) {
                carryOutAll();
            }
        }
    }

    @Override
    public boolean isSlow() {
        return outbox.isFull() || !outbox.isEmpty();
    }

    @Override
    public void send(@Nullable JsonNode id, JsonForm.Content content) {
        byte[] text = shared.form().bytes(content);
        if (fragments.isDividing(text.length)) {
            fragments.divided(id, new String(text, StandardCharsets.UTF_8)).stream()
                    .map(shared.form()::bytes)
                    .forEach(this::sendText);
        } else {
            sendText(text);
        }
    }

    /** Sends a message of this size, which nothing asked for: odometry with a long name of its frame. */
    void sendHuge(int bytes) {
        byte[] text = new byte[bytes];
        Arrays.fill(text, (byte) 'x');
        byte[] head = HUGE_HEAD.getBytes(StandardCharsets.UTF_8);
        byte[] tail = HUGE_TAIL.getBytes(StandardCharsets.UTF_8);
        System.arraycopy(head, 0, text, 0, head.length);
        System.arraycopy(tail, 0, text, bytes - tail.length, tail.length);
        sendText(text);
    }

    private void sendText(byte[] text) {
        if (socket.isOpen() && !shared.faults().isHanging()) {
            outbox.text(shared.faults().takeMalformed() ? Arrays.copyOf(text, text.length / 2) : text);
        }
    }

    @Override
    public void sendBinary(byte[] payload) {
        if (socket.isOpen() && !shared.faults().isHanging()) {
            outbox.binary(payload);
        }
    }
}
