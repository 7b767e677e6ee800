package majic.shared.broker;

import static majic.shared.broker.RawBroker.property;
import static majic.shared.broker.RawBroker.publish;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests what the client library ends the connection for: messages that break the rules of MQTT, and other packets. */
class MalformedMessageTest {
    private static final String TOPIC = "lab/majic/1/stop";
    private static final int RESPONSE_TOPIC = 8;
    private static final int CONTENT_TYPE = 3;
    private static final byte[] GOOD = publish("lab/good", property(RESPONSE_TOPIC, utf8("lab/answers")));

    private final List<String> malformed = new CopyOnWriteArrayList<>();
    private final List<String> lost = new CopyOnWriteArrayList<>();
    private final List<String> refused = new CopyOnWriteArrayList<>();
    private final CompletableFuture<String> firstLoss = new CompletableFuture<>();
    private final CompletableFuture<String> firstRefusal = new CompletableFuture<>();

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private BrokerConnection connection(RawBroker broker) {
        BrokerConnection connection = BrokerConnection.open(
                broker.address(),
                ConnectOptions.of("reader", new BotEnvironment(TimeSource.system(), Settings.inMemory()))
                        .withTimeoutMs(WaitLimit.MS)
                        .withKeepAlive(WaitLimit.SECONDS));
        connection.watch(new BrokerConnection.Watcher() {
            @Override
            public void malformed(String topic, String problem) {
                malformed.add(topic + ": " + problem);
            }

            @Override
            public void lost(String reason) {
                lost.add(reason);
                firstLoss.complete(reason);
            }

            @Override
            public void notSubscribed(String filter, String reason) {
                refused.add(filter + ": " + reason);
                firstRefusal.complete(reason);
            }
        });
        return connection;
    }

    static Stream<Arguments> malformedMessages() {
        byte[] wildcard = property(RESPONSE_TOPIC, utf8("a/+/b"));
        byte[] twice = new byte[2 * wildcard.length];
        System.arraycopy(property(RESPONSE_TOPIC, utf8("a/c/b")), 0, twice, 0, wildcard.length);
        System.arraycopy(property(RESPONSE_TOPIC, utf8("a/c/b")), 0, twice, wildcard.length, wildcard.length);
        return Stream.of(
                Arguments.of(publish(TOPIC, wildcard), "its response topic \"a/+/b\" contains a wildcard"),
                Arguments.of(
                        publish(TOPIC, property(RESPONSE_TOPIC, utf8("#"))),
                        "its response topic \"#\" contains a wildcard"),
                Arguments.of(publish(TOPIC, property(RESPONSE_TOPIC, utf8(""))), "its response topic is empty"),
                Arguments.of(
                        publish(TOPIC, property(RESPONSE_TOPIC, new byte[] {(byte) 0xC0, (byte) 0x80})),
                        "its response topic is not UTF-8"),
                Arguments.of(
                        publish(TOPIC, property(RESPONSE_TOPIC, utf8("a\0b"))),
                        "its response topic contains the character U+0000"),
                Arguments.of(publish(TOPIC, twice), "it has a property twice (8)"),
                Arguments.of(
                        publish(TOPIC, property(CONTENT_TYPE, new byte[] {(byte) 0xED, (byte) 0xA0, (byte) 0x80})),
                        "its content type is not UTF-8"),
                Arguments.of(
                        publish(TOPIC, property(0x26, utf8("a\0"))), "a user property contains the character U+0000"),
                Arguments.of(publish(TOPIC, (byte) 1, (byte) 2), "its payload format indicator is 2 instead of 0 or 1"),
                Arguments.of(publish(TOPIC, (byte) 0x7F), "it has a property that does not exist (127)"),
                Arguments.of(
                        publish(TOPIC, (byte) 2, (byte) 0, (byte) 0, (byte) 0),
                        "the length of its properties is wrong"),
                Arguments.of(publish(TOPIC, (byte) RESPONSE_TOPIC, (byte) 1, (byte) 0), "it ends too early"));
    }

    @ParameterizedTest
    @MethodSource("malformedMessages")
    void aMalformedMessageIsLeftOutAndTheConnectionGoesOn(byte[] packet, String problem) throws Exception {
        try (RawBroker broker = new RawBroker(1, List.of(packet, GOOD));
                BrokerConnection connection = connection(broker)) {
            connection.connect();
            CompletableFuture<BrokerMessage> good = new CompletableFuture<>();
            connection.subscribe("#", Quality.AT_LEAST_ONCE, good::complete);

            BrokerMessage message = good.get(WaitLimit.SECONDS, TimeUnit.SECONDS);
            assertThat(message.topic()).isEqualTo("lab/good");
            assertThat(message.responseTopic()).isEqualTo("lab/answers");
            connection.publish(BrokerMessage.json("lab/x", "{}", Quality.AT_MOST_ONCE));
            assertThat(malformed).containsExactly(TOPIC + ": " + problem);
            assertThat(lost).isEmpty();
            assertThat(broker.connections()).isOne();
        }
    }

    @Test
    void messagesThatArriveInPiecesAreReadWhole() throws Exception {
        byte[] large = publish("lab/large/" + "x".repeat(100));
        byte[] first = Arrays.copyOf(large, 30);
        byte[] second = Arrays.copyOfRange(large, 30, large.length);
        try (RawBroker broker = new RawBroker(1, List.of(first, second, GOOD, GOOD));
                BrokerConnection connection = connection(broker)) {
            connection.connect();
            List<String> topics = new CopyOnWriteArrayList<>();
            CompletableFuture<Void> all = new CompletableFuture<>();
            connection.subscribe("#", Quality.AT_LEAST_ONCE, message -> {
                topics.add(message.topic());
                if (topics.size() == 3) {
                    all.complete(null);
                }
            });

            all.get(WaitLimit.SECONDS, TimeUnit.SECONDS);
            assertThat(topics).containsExactly("lab/large/" + "x".repeat(100), "lab/good", "lab/good");
        }
    }

    @Test
    void anotherPacketThatIsMalformedEndsTheConnectionWithTheReason() throws Exception {
        byte[] wrong = {(byte) 0x40, 1, 0};
        try (RawBroker broker = new RawBroker(1, List.of(wrong));
                BrokerConnection connection = connection(broker)) {
            connection.connect();
            connection.subscribe("#", Quality.AT_LEAST_ONCE, message -> {});

            assertThat(firstLoss.get(WaitLimit.SECONDS, TimeUnit.SECONDS))
                    .startsWith("the broker has sent something malformed: ");
        }
    }

    @Test
    void aSubscriptionThatIsRefusedWithTheConnectionIsReported() throws Exception {
        try (RawBroker broker = new RawBroker(0x87, List.of());
                BrokerConnection connection = connection(broker)) {
            connection.subscribe(TOPIC, Quality.AT_LEAST_ONCE, message -> {});
            connection.connect();

            assertThat(firstRefusal.get(WaitLimit.SECONDS, TimeUnit.SECONDS)).isEqualTo("not authorized");
            assertThat(refused).containsExactly(TOPIC + ": not authorized");
        }
    }
}
