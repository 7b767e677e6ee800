package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.ros.websocket.WebSocketClient;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;

/**
 * One connection to a rosbridge server. Everything is sent on the calling thread, in the order of the calls, within the
 * write deadline of the link: a stop waits for at most one message that is being written. Errors of most operations are
 * silent (rosbridge sheet 1): only calls of services report them. Thread-safe.
 */
public final class RosBridge implements AutoCloseable {
    /** The length of the longest message that is received, bytes; a longer one is skipped with a notice. */
    public static final int LONGEST_MESSAGE = 16 << 20;

    private final TimeSource time;
    private final Signal answers;
    private final Listener listener;
    private final WebSocketClient socket;
    private final PendingCalls calls = new PendingCalls();
    private final Goals goals = new Goals();
    private final Map<String, TopicStream> streams = new ConcurrentHashMap<>();
    private volatile boolean leftOut;

    /** Handles what concerns the whole connection. Called on the reader thread, which must not wait. */
    public interface Listener {
        /**
         * Handles the end of the connection, once. All calls have failed by then.
         *
         * @param bridge the connection
         * @param cause why it ended
         */
        void lost(RosBridge bridge, LinkLost cause);

        /**
         * Handles a message for the user; sent once for each kind on a connection.
         *
         * @param message one sentence
         */
        void notice(String message);
    }

    private RosBridge(BridgeAddress address, TimeSource time, Listener listener) {
        this.time = time;
        this.answers = time.signal();
        this.listener = listener;
        OperationRouter router = new OperationRouter(new Routes());
        this.socket = new WebSocketClient(
                address.newLink(), address.hostAndPort(), address.path(), LONGEST_MESSAGE, time, router);
    }

    /**
     * Connects to a server.
     *
     * @param address where it is
     * @param timeoutMs how long to try at most, ms
     * @param time the clock of all waits
     * @param listener handles the end
     * @return the connection
     * @throws ConnectFailed if there is no rosbridge server; the message says what is there, and what to do. Nothing
     *     stays open
     */
    public static RosBridge open(BridgeAddress address, int timeoutMs, TimeSource time, Listener listener) {
        RosBridge bridge = new RosBridge(address, time, listener);
        try {
            bridge.socket.open(timeoutMs);
        } catch (IOException e) {
            throw BridgeErrors.explained(e, address);
        }
        return bridge;
    }

    /**
     * Calls a service and waits for its answer.
     *
     * @param service its absolute name
     * @param arguments its arguments by name
     * @param timeoutS the longest wait, s
     * @return the values of the answer, an object
     * @throws ServiceFailed if the server reports a failure, or does not answer in time
     * @throws LinkLost if the connection ends meanwhile
     * @throws BotException if the thread may not wait, or is interrupted
     */
    public JsonNode call(String service, JsonNode arguments, double timeoutS) {
        if (!WaitPolicy.isAllowed()) {
            throw new BotException(service + " cannot be called here, because nothing may wait here");
        }
        ServiceCall call = new ServiceCall(service, answers::raise);
        String id = request(call, arguments);
        try {
            answers.await(call::isDone, timeoutS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while " + service + " was called", e);
        } finally {
            calls.remove(id);
        }
        JsonNode values = call.result();
        if (values == null) {
            throw new ServiceFailed(service + " did not answer within " + timeoutS + " s", false);
        }
        return values;
    }

    /**
     * Calls a service without waiting. The answer is ignored.
     *
     * @param service its absolute name
     * @param arguments its arguments by name
     * @throws LinkLost if the request could not be sent
     */
    public void request(String service, JsonNode arguments) {
        ServiceCall call = new ServiceCall(service, () -> {});
        calls.remove(request(call, arguments));
    }

    /**
     * Calls a service without waiting.
     *
     * @param service its absolute name
     * @param arguments its arguments by name
     * @param changed called when the call is over, on the reader thread; must not wait
     * @return the answer, to be closed
     * @throws LinkLost if the request could not be sent
     */
    public ServiceReply begin(String service, JsonNode arguments, Runnable changed) {
        ServiceCall call = new ServiceCall(service, changed);
        String id = request(call, arguments);
        return new ServiceReply(call, () -> calls.remove(id));
    }

    private String request(ServiceCall call, JsonNode arguments) {
        String id = calls.add(call);
        ObjectNode operation = operation("call_service");
        operation.put("id", id);
        operation.put("service", call.service());
        operation.set("args", arguments);
        try {
            send(operation);
        } catch (RuntimeException e) {
            calls.remove(id);
            throw e;
        }
        return id;
    }

    /**
     * Subscribes to a topic.
     *
     * @param wanted the topic, its type, and how often
     * @param onMessage receives each message, on the reader thread; must not wait. What it throws is logged
     * @return the subscription, to be closed; it ends with the connection
     * @throws LinkLost if it could not be sent
     */
    public RosSubscription subscribe(TopicSubscription wanted, Consumer<JsonNode> onMessage) {
        return subscribeSized(wanted, (message, bytes) -> onMessage.accept(message));
    }

    /**
     * Subscribes to a topic, as {@link #subscribe}, with the lengths of the messages.
     *
     * @param wanted the topic, its type, and how often
     * @param onMessage receives each message and its length
     * @return the subscription, to be closed; it ends with the connection
     * @throws LinkLost if it could not be sent
     */
    public RosSubscription subscribeSized(TopicSubscription wanted, MessageReceiver onMessage) {
        return streams.computeIfAbsent(wanted.topic(), topic -> new TopicStream(time, this::send))
                .add(wanted, onMessage);
    }

    /**
     * Subscribes again to topics from which nothing has arrived for some seconds. Called about once a second.
     *
     * @throws LinkLost if it could not be sent
     */
    public void renewSilentSubscriptions() {
        Collection<TopicStream> all = streams.values();
        all.forEach(TopicStream::renewIfSilent);
    }

    /**
     * Returns the topics that are subscribed to on this connection. Never blocks.
     *
     * @return in no order
     */
    public List<TopicActivity> activity() {
        return streams.values().stream()
                .flatMap(stream -> stream.activity().stream())
                .toList();
    }

    /**
     * Returns what is arriving now.
     *
     * @return the message that is not complete; left out counts from one message that was too long to the next one that
     *     was not
     */
    public Arriving arriving() {
        return new Arriving(socket.arrivedBytes(), socket.knownBytes(), leftOut);
    }

    /**
     * Announces that messages of a topic will be published.
     *
     * @param topic its absolute name
     * @param type as rosapi names it
     * @throws LinkLost if it could not be sent
     */
    public void advertise(String topic, String type) {
        ObjectNode operation = operation("advertise");
        operation.put("id", "majic:" + topic);
        operation.put("topic", topic);
        operation.put("type", type);
        send(operation);
    }

    /**
     * Withdraws an announcement.
     *
     * @param topic its absolute name
     * @throws LinkLost if it could not be sent
     */
    public void unadvertise(String topic) {
        ObjectNode operation = operation("unadvertise");
        operation.put("id", "majic:" + topic);
        operation.put("topic", topic);
        send(operation);
    }

    /**
     * Publishes a message.
     *
     * @param topic its absolute name
     * @param message an object; numbers must be finite, and whole ones for integer fields
     * @throws LinkLost if it could not be sent
     * @throws IllegalArgumentException if a number is not finite; nothing was sent
     */
    public void publish(String topic, JsonNode message) {
        ObjectNode operation = operation("publish");
        operation.put("topic", topic);
        operation.set("msg", message);
        send(operation);
    }

    /**
     * Sends the goal of an action (ROS 2 only).
     *
     * @param goal the action and its arguments
     * @param events receives feedback and the result, on the reader thread; must not wait
     * @return the id of the goal, for {@link #cancelGoal}
     * @throws LinkLost if it could not be sent
     */
    public String sendGoal(ActionGoal goal, ActionGoal.Events events) {
        String id = goals.add(events);
        ObjectNode operation = operation("send_action_goal");
        operation.put("id", id);
        operation.put("action", goal.action());
        operation.put("action_type", goal.type());
        operation.set("args", goal.arguments());
        operation.put("feedback", true);
        try {
            send(operation);
        } catch (RuntimeException e) {
            goals.remove(id);
            throw e;
        }
        return id;
    }

    /**
     * Cancels a goal. May be sent on another connection than the goal itself, whose own is blocked by servers up to
     * 2.1.0.
     *
     * @param action its absolute name
     * @param id as returned by {@link #sendGoal}
     * @throws LinkLost if it could not be sent
     */
    public void cancelGoal(String action, String id) {
        ObjectNode operation = operation("cancel_action_goal");
        operation.put("id", id);
        operation.put("action", action);
        send(operation);
    }

    /**
     * Asks the server for a sign of life.
     *
     * @throws LinkLost if it could not be sent
     */
    public void ping() {
        socket.ping();
    }

    /**
     * Returns how long nothing has arrived.
     *
     * @return seconds since the last byte of a message or of an answer to a ping
     */
    public double silenceS() {
        return socket.silenceS();
    }

    /**
     * Returns how long a message takes to the server and back, by the newest ping.
     *
     * @return seconds; at least the time that an answer has been due; 0 before the first answer
     */
    public double roundTripS() {
        return socket.roundTripS();
    }

    /**
     * Returns whether the connection can be used.
     *
     * @return false from its end on
     */
    public boolean isOpen() {
        return socket.isOpen();
    }

    /**
     * Ends the connection in order.
     *
     * @param seconds how long to wait at most until the server has closed it
     */
    public void close(double seconds) {
        socket.close(seconds);
    }

    /** Ends the connection without a wait. */
    @Override
    public void close() {
        socket.close();
    }

    /** Cuts the connection at once. */
    public void abort() {
        socket.abort();
    }

    private void send(ObjectNode operation) {
        socket.send(BridgeCodec.encode(operation));
    }

    private static ObjectNode operation(String name) {
        return JsonNodeFactory.instance.objectNode().put("op", name);
    }

    /** The receivers of the messages of this connection. */
    private final class Routes implements OperationRouter.Routes {
        @Override
        public void published(String topic, JsonNode message, int bytes) {
            leftOut = false;
            TopicStream stream = streams.get(topic);
            if (stream != null) {
                stream.receive(message, bytes);
            }
        }

        @Override
        public void leftOut() {
            leftOut = true;
        }

        @Override
        public void answered(ObjectNode response) {
            calls.answered(response);
        }

        @Override
        public void feedback(ObjectNode feedback) {
            goals.feedback(feedback);
        }

        @Override
        public void result(ObjectNode result) {
            goals.result(result);
        }

        @Override
        public void notice(String message) {
            listener.notice(message);
        }

        @Override
        public void ended(IOException cause) {
            LinkLost lost = new LinkLost(String.valueOf(cause.getMessage()), cause);
            calls.end(lost);
            goals.end(lost);
            listener.lost(RosBridge.this, lost);
        }
    }
}
