package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import majic.environment.BotEnvironment;
import majic.link.Loopback;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the access list in {@code examples/mosquitto} with Mosquitto, where it is installed. */
@EnabledIf("isInstalled")
class AccessListTest {
    private static final String TOPICS = "lab/majic/1/";

    @TempDir
    private static Path folder;

    private static Mosquitto broker;

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    @BeforeAll
    static void start() throws IOException, InterruptedException {
        Path users = Files.writeString(folder.resolve("users"), "olga:pw-olga\ndirk:pw-dirk\ndesk2:pw-desk2\n");
        assertThat(new ProcessBuilder("mosquitto_passwd", "-U", users.toString())
                        .inheritIO()
                        .start()
                        .waitFor())
                .isZero();
        broker = Mosquitto.start(
                folder,
                Loopback.freePort(),
                "allow_anonymous false",
                "password_file " + users,
                "acl_file " + Path.of("examples", "mosquitto", "majic.acl").toAbsolutePath());
    }

    @AfterAll
    static void stop() {
        if (broker != null) {
            broker.close();
        }
    }

    private static BrokerConnection as(String user) throws IOException {
        Path home = Files.createTempDirectory(folder, user);
        BotEnvironment environment = WrittenCredentials.in(
                        home, "broker.127.0.0.1.user=" + user, "broker.127.0.0.1.password=pw-" + user)
                .environment();
        BrokerConnection connection = BrokerConnection.open(
                BrokerAddress.parse("mqtt://127.0.0.1:" + broker.port() + "/lab"),
                ConnectOptions.of(user, environment).withTimeoutMs(WaitLimit.MS));
        connection.connect();
        return connection;
    }

    /** Publishes a message, and returns the answer of the broker. */
    private static String answer(String user, String topic) throws Exception {
        CompletableFuture<String> answer = new CompletableFuture<>();
        try (BrokerConnection connection = as(user)) {
            connection.publish(
                    BrokerMessage.json(TOPICS + topic, "{}", Quality.AT_LEAST_ONCE),
                    refusal -> answer.complete(refusal == null ? "accepted" : "refused: " + refusal.getMessage()));
            return answer.get(WaitLimit.SECONDS, TimeUnit.SECONDS);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "olga, desks/desk2/robots/1/stop",
        "olga, stop",
        "dirk, desks/desk2/robots/1/request",
        "dirk, desks/desk2/robots/1/hold",
        "dirk, desks/desk2/robots/1/stop",
        "dirk, stop",
        "desk2, desks/desk2/robots/1/state",
        "desk2, replies/s-1",
        "desk2, desks/desk3/robots/1/request"
    })
    void whatARoleMayDoIsAccepted(String user, String topic) throws Exception {
        assertThat(answer(user, topic)).isEqualTo("accepted");
    }

    @ParameterizedTest
    @ValueSource(strings = {"olga", "dirk"})
    void onlyDesksReceiveWhatIsSentToTheirRobots(String user) throws Exception {
        List<String> received = new CopyOnWriteArrayList<>();
        CompletableFuture<Void> end = new CompletableFuture<>();
        try (BrokerConnection reader = as(user);
                BrokerConnection desk = as("desk2")) {
            reader.subscribe(TOPICS + "#", Quality.AT_LEAST_ONCE, message -> {
                received.add(message.topic().substring(TOPICS.length()));
                if (message.topic().endsWith("messages")) {
                    end.complete(null);
                }
            });
            for (String part : List.of(
                    "request", "speed", "hold", "stop", "description", "state", "changes", "scans", "messages")) {
                desk.publish(BrokerMessage.json(TOPICS + "desks/desk2/robots/9/" + part, "{}", Quality.AT_LEAST_ONCE));
            }
            end.get(WaitLimit.SECONDS, TimeUnit.SECONDS);
        }

        assertThat(received)
                .containsExactly(
                        "desks/desk2/robots/9/description",
                        "desks/desk2/robots/9/state",
                        "desks/desk2/robots/9/changes",
                        "desks/desk2/robots/9/scans",
                        "desks/desk2/robots/9/messages");
    }

    @ParameterizedTest
    @CsvSource({
        "olga, desks/desk2/robots/1/request",
        "olga, desks/desk2/robots/1/speed",
        "olga, desks/desk2/presence",
        "dirk, desks/desk2/robots/1/state",
        "dirk, desks/desk2/presence",
        "desk2, desks/desk3/presence"
    })
    void whatARoleMayNotDoIsRefused(String user, String topic) throws Exception {
        assertThat(answer(user, topic)).startsWith("refused: ").endsWith(": not authorized");
    }
}
