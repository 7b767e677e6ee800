package majic.ros.readings;

import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import majic.bot.BotException;
import majic.ros.bridge.ActionGoal;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.TopicSubscription;

/** The connection with a robot that is played by the test: it publishes, answers calls, and keeps what was sent. */
public final class FakeRosClient implements RosClient {
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_SINGLE_QUOTES, JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();

    /** The answer of a service that never answers. */
    public static final Function<JsonNode, JsonNode> NEVER = arguments -> MissingNode.getInstance();

    /** What was sent, each as {@code publish /topic {…}}, {@code call /service {…}}, {@code goal /action {…}} … */
    public final List<String> sent = new CopyOnWriteArrayList<>();

    /** The newest goal of an action. */
    public volatile ActionGoal.Events goal;

    /** What was subscribed to beside the robot's own connection, in order. */
    public final List<TopicSubscription> wishes = new CopyOnWriteArrayList<>();

    /** The length of each message of these. */
    public volatile int messageBytes = 1000;

    /** What is arriving of these. */
    public volatile Arriving arriving = Arriving.NOTHING;

    private final List<Runnable> lost = new CopyOnWriteArrayList<>();
    private final boolean ros2;
    private final Map<String, String> topics;
    private final Map<String, List<Consumer<JsonNode>>> subscriptions = new ConcurrentHashMap<>();
    private final Map<String, Function<JsonNode, JsonNode>> services = new ConcurrentHashMap<>();

    public FakeRosClient(boolean ros2, Map<String, String> topics) {
        this.ros2 = ros2;
        this.topics = Map.copyOf(topics);
    }

    /** Parses JSON, in which single quotes may stand for double ones. */
    public static JsonNode json(String text) {
        try {
            return JSON.readTree(text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Lets the robot publish a message. */
    public void robotPublishes(String topic, String message) {
        subscriptions.getOrDefault(topic, List.of()).forEach(each -> each.accept(json(message)));
    }

    /** Lets the robot have a service. */
    public void robotOffers(String service, Function<JsonNode, JsonNode> answer) {
        services.put(service, answer);
    }

    /** Returns the topics that are subscribed to, in alphabetical order. */
    public List<String> subscribed() {
        return subscriptions.entrySet().stream()
                .filter(topic -> !topic.getValue().isEmpty())
                .map(Map.Entry::getKey)
                .sorted()
                .toList();
    }

    @Override
    public boolean isRos2() {
        return ros2;
    }

    @Override
    public String namespace() {
        return "";
    }

    @Override
    public Map<String, String> topics() {
        return topics;
    }

    @Override
    public Map<String, String> listTopics() {
        return topics;
    }

    @Override
    public Runnable subscribe(TopicSubscription wanted, Consumer<JsonNode> onMessage) {
        List<Consumer<JsonNode>> all =
                subscriptions.computeIfAbsent(wanted.topic(), topic -> new CopyOnWriteArrayList<>(new ArrayList<>()));
        all.add(onMessage);
        return () -> all.remove(onMessage);
    }

    @Override
    public TopicSource sensors() {
        return new Source();
    }

    @Override
    public TopicSource large() {
        return new Source();
    }

    /** Lets the connections beside the robot's own one be lost. */
    public void losesSideConnections() {
        lost.forEach(Runnable::run);
    }

    /** The connections beside the robot's own one. */
    private final class Source implements TopicSource {
        @Override
        public Runnable subscribe(TopicSubscription wanted, Receiver receiver) {
            wishes.add(wanted);
            lost.add(receiver::lost);
            return FakeRosClient.this.subscribe(wanted, message -> receiver.message(message, messageBytes));
        }

        @Override
        public double roundTripS() {
            return 0.02;
        }

        @Override
        public Arriving arriving() {
            return arriving;
        }
    }

    @Override
    public JsonNode ask(String question, JsonNode arguments, double timeoutS) {
        return call("/rosapi/" + question, arguments, timeoutS);
    }

    @Override
    public JsonNode call(String service, JsonNode arguments, double timeoutS) {
        if (service.equals("/rosapi/service_type")) {
            boolean known = services.containsKey(arguments.path("service").asText());
            return JsonNodeFactory.instance.objectNode().put("type", known ? "test/Service" : "");
        }
        sent.add("call " + service + " " + arguments);
        Function<JsonNode, JsonNode> answer = services.get(service);
        if (answer == null) {
            throw new BotException("Service " + service + " does not exist");
        }
        return answer.apply(arguments);
    }

    @Override
    public void request(String service, JsonNode arguments) {
        sent.add("request " + service + " " + arguments);
    }

    @Override
    public void publish(String topic, String type, JsonNode message) {
        sent.add("publish " + topic + " " + message);
    }

    @Override
    public CallChannel openCall(Runnable changed) {
        return new CallChannel() {
            private volatile JsonNode values;

            @Override
            public void send(String service, JsonNode arguments) {
                if (services.get(service) == NEVER) {
                    sent.add("call " + service + " " + arguments);
                } else {
                    values = call(service, arguments, 0);
                    changed.run();
                }
            }

            @Override
            public boolean isDone() {
                return values != null;
            }

            @Override
            public Optional<JsonNode> values() {
                return Optional.ofNullable(values);
            }

            @Override
            public void close() {
                sent.add("close call");
            }
        };
    }

    @Override
    public GoalChannel openGoal() {
        return new GoalChannel() {
            @Override
            public void send(ActionGoal sentGoal, ActionGoal.Events events) {
                sent.add("goal " + sentGoal.action() + " " + sentGoal.arguments());
                goal = events;
            }

            @Override
            public void cancel() {
                sent.add("cancel");
            }

            @Override
            public void close() {
                sent.add("close");
            }
        };
    }
}
