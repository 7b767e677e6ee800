package majic.ros;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import majic.bot.BotAddress;
import majic.bot.Pose;
import majic.drivertest.ScriptedPeer;
import majic.drivertest.TestedRobot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;

/**
 * A base behind a rosbridge server of ROS 1, on a stepped clock, as a turtlebot3_fake with rosapi answers in the
 * recorded session: it follows velocities with limited acceleration, stops 0.5 s after the last one, and reports its
 * odometry 30 times a second. It accepts one connection, so that nothing is read that needs a further one.
 */
final class ScriptedRos implements TestedRobot, ScriptedPeer.Robot {
    static final ObjectMapper JSON = new ObjectMapper();

    private static final double TIMEOUT_MS = 500;
    private static final double ACCELERATION = 1.5;
    private static final double TURN_ACCELERATION = 8;
    private static final int ODOMETRY_PERIOD_MS = 33;

    final Map<String, String> topics = new LinkedHashMap<>();
    final Map<String, List<String>> subscribers = new LinkedHashMap<>();
    final Map<String, Function<JsonNode, JsonNode>> services = new LinkedHashMap<>();
    final Map<String, String> parameters =
            new LinkedHashMap<>(Map.of("/rosdistro", "noetic\n", "/tb3_model", "burger"));
    final List<JsonNode> received = new ArrayList<>();
    final List<String> nodes = new ArrayList<>(List.of("/rosbridge_websocket", "/turtlebot3_fake_node", "/rosapi"));
    final ScriptedPeer peer;
    private final MajicRos bot;
    private final Map<String, Integer> subscribed = new LinkedHashMap<>();
    private ServerFrames frames = new ServerFrames();

    /** Answers a call with the text of a whole message; with none, {@link #services} answer it. */
    Function<JsonNode, String> wholeAnswer = call -> "";

    volatile int pongs;
    boolean silent;
    boolean reports = true;
    boolean hangsUpAtFirstRequest;
    private boolean blocked;
    private double x = 1.5;
    private double y = -0.4;
    private double yaw = 0.7;
    private double speed;
    private double rate;
    private double wantedSpeed;
    private double wantedRate;
    private long commandedMs;

    ScriptedRos() {
        this("");
    }

    /**
     * Creates a robot.
     *
     * @param behindPort the rest of its address behind the port
     */
    ScriptedRos(String behindPort) {
        topics.put("/cmd_vel", "geometry_msgs/Twist");
        topics.put("/odom", "nav_msgs/Odometry");
        subscribers.put("/cmd_vel", List.of("/turtlebot3_fake_node"));
        services.put("/rosapi/topics", this::listTopics);
        services.put("/rosapi/nodes", arguments -> list("nodes", nodes));
        services.put(
                "/rosapi/subscribers",
                arguments -> list(
                        "subscribers",
                        subscribers.getOrDefault(arguments.path("topic").asText(), List.of())));
        services.put("/rosapi/get_param", this::parameter);
        peer = new ScriptedPeer(this);
        peer.refuseFurther();
        bot = new MajicRos(
                new BotAddress("ros", "//" + peer.address() + behindPort),
                new BotEnvironment(peer.clock().time(), Settings.inMemory()));
    }

    private JsonNode listTopics(JsonNode arguments) {
        ObjectNode answer = list("topics", List.copyOf(topics.keySet()));
        answer.setAll(list("types", List.copyOf(topics.values())));
        return answer;
    }

    private JsonNode parameter(JsonNode arguments) {
        String value = parameters.get(arguments.path("name").asText());
        return JSON.createObjectNode().put("value", JSON.valueToTree(value).toString());
    }

    static ObjectNode list(String name, List<String> values) {
        ObjectNode object = JSON.createObjectNode();
        ArrayNode array = object.putArray(name);
        values.forEach(array::add);
        return object;
    }

    @Override
    public MajicRos bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        synchronized (peer) {
            return new Pose(x * 1000, y * 1000, Math.toDegrees(yaw));
        }
    }

    @Override
    public void cut() {
        peer.hangUp();
        frames = new ServerFrames();
    }

    @Override
    public void fallSilent() {
        synchronized (peer) {
            silent = true;
        }
    }

    /** Ends a silence. */
    void speakAgain() {
        synchronized (peer) {
            silent = false;
        }
    }

    /** Returns the newest operation; one that ends the connection is called close. */
    JsonNode newest() {
        synchronized (peer) {
            return received.get(received.size() - 1);
        }
    }

    @Override
    public void block() {
        synchronized (peer) {
            blocked = true;
        }
    }

    @Override
    public void unblock() {
        synchronized (peer) {
            blocked = false;
        }
    }

    @Override
    public void close() {
        bot.close();
        peer.close();
    }

    @Override
    public void connected(ScriptedPeer connected) {
        frames = new ServerFrames();
        subscribed.clear();
        silent = false;
    }

    @Override
    public void received(ScriptedPeer from, byte[] bytes) {
        frames.receive(bytes, from::send, this::frame);
    }

    private void frame(int opcode, byte[] content) {
        if (opcode == ServerFrames.PING && !silent) {
            peer.send(ServerFrames.frame(ServerFrames.PONG, content));
        } else if (opcode == ServerFrames.PONG) {
            pongs++;
        } else if (opcode == ServerFrames.CLOSE) {
            received.add(JSON.createObjectNode().put("op", "close"));
            peer.hangUp();
        } else if (opcode == ServerFrames.TEXT) {
            operation(parse(new String(content, StandardCharsets.UTF_8)));
        }
    }

    static JsonNode parse(String text) {
        try {
            return JSON.readTree(text);
        } catch (JsonProcessingException e) {
            throw new AssertionError("not JSON: " + text, e);
        }
    }

    private void operation(JsonNode operation) {
        received.add(operation);
        switch (operation.path("op").asText()) {
            case "call_service" -> call(operation);
            case "subscribe" ->
                subscribed.put(
                        operation.path("topic").asText(),
                        operation.path("throttle_rate").asInt());
            case "unsubscribe" -> subscribed.remove(operation.path("topic").asText());
            case "publish" -> publish(operation);
            default -> {
                // advertise and unadvertise: there is nothing to do
            }
        }
    }

    private void call(JsonNode operation) {
        String whole = wholeAnswer.apply(operation);
        if (hangsUpAtFirstRequest) {
            peer.hangUp();
            return;
        }
        if (!whole.isEmpty()) {
            peer.send(ServerFrames.text(whole));
            return;
        }
        String service = operation.path("service").asText();
        Function<JsonNode, JsonNode> answer = services.get(service);
        ObjectNode response = JSON.createObjectNode().put("op", "service_response");
        response.put("service", service).set("id", operation.path("id"));
        if (answer == null) {
            response.put("values", "Service " + service + " does not exist").put("result", false);
        } else {
            response.put("result", true).set("values", answer.apply(operation.path("args")));
        }
        send(response);
    }

    private void publish(JsonNode operation) {
        if (operation.path("topic").asText().equals("/cmd_vel")) {
            JsonNode message = operation.path("msg");
            wantedSpeed = message.path("linear").path("x").asDouble();
            wantedRate = message.path("angular").path("z").asDouble();
            commandedMs = peer.millis();
        }
    }

    /** Sends a message as the real server does, which escapes slashes. */
    void send(JsonNode message) {
        if (!silent) {
            peer.send(ServerFrames.text(message.toString().replace("/", "\\/")));
        }
    }

    boolean isSubscribed(String topic) {
        synchronized (peer) {
            return subscribed.containsKey(topic);
        }
    }

    /** Publishes a message to the driver if it has subscribed to the topic. */
    void publish(String topic, JsonNode message) {
        if (subscribed.containsKey(topic)) {
            ObjectNode operation = JSON.createObjectNode().put("op", "publish").put("topic", topic);
            operation.set("msg", message);
            send(operation);
        }
    }

    @Override
    public void step(ScriptedPeer stepped) {
        if (stepped.millis() - commandedMs > TIMEOUT_MS) {
            wantedSpeed = 0;
            wantedRate = 0;
        }
        speed = blocked ? 0 : towards(speed, wantedSpeed, ACCELERATION / 1000);
        rate = towards(rate, wantedRate, TURN_ACCELERATION / 1000);
        yaw += rate / 1000;
        x += Math.cos(yaw) * speed / 1000;
        y += Math.sin(yaw) * speed / 1000;
        if (reports && stepped.millis() % ODOMETRY_PERIOD_MS == 0) {
            publish("/odom", odometry());
        }
    }

    private static double towards(double now, double wanted, double step) {
        return Math.abs(wanted - now) <= step ? wanted : now + Math.copySign(step, wanted - now);
    }

    ObjectNode odometry() {
        ObjectNode odometry = JSON.createObjectNode();
        odometry.putObject("header").put("frame_id", "odom");
        odometry.put("child_frame_id", "base_footprint");
        ObjectNode pose = odometry.putObject("pose").putObject("pose");
        pose.putObject("position").put("x", x).put("y", y).put("z", 0.0);
        pose.putObject("orientation")
                .put("x", 0.0)
                .put("y", 0.0)
                .put("z", Math.sin(yaw / 2))
                .put("w", Math.cos(yaw / 2));
        ObjectNode twist = odometry.putObject("twist").putObject("twist");
        twist.putObject("linear").put("x", speed).put("y", 0.0).put("z", 0.0);
        twist.putObject("angular").put("x", 0.0).put("y", 0.0).put("z", rate);
        return odometry;
    }
}
