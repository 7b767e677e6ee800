package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A broker that accepts a client, which may have one unacknowledged message, and then neither reads nor answers. */
class StalledBrokerTest {
    private static final int KEEP_ALIVE_SECONDS = 3600;
    private static final byte RECEIVE_MAXIMUM = 0x21;
    private static final byte[] ACCEPTED = {0x20, 6, 0, 0, 3, RECEIVE_MAXIMUM, 0, 1};
    private static final int MANY = 2000;

    @AutoClose
    private final ScriptedServer server = new ScriptedServer(ACCEPTED);

    @AutoClose
    private final BrokerConnection connection = BrokerConnection.open(
            BrokerAddress.parse("mqtt://127.0.0.1:" + server.port() + "/lab"),
            ConnectOptions.of("a", BotEnvironment.plain()).withKeepAlive(KEEP_ALIVE_SECONDS));

    @BeforeEach
    void connect() {
        connection.connect();
    }

    @Test
    void publishingDoesNotWaitForIt() {
        for (int i = 0; i < MANY; i++) {
            connection.publish(BrokerMessage.json("state", "{}", Quality.AT_MOST_ONCE));
            connection.publish(BrokerMessage.json("stop", "{}", Quality.AT_LEAST_ONCE));
        }

        assertThat(connection.isConnected()).isTrue();
    }

    @Test
    void statesAreDroppedWhenTooMuchWaitsAndStopsAreNot() {
        byte[] large = new byte[1 << 20];
        BrokerMessage state = BrokerMessage.json("state", large, Quality.AT_MOST_ONCE);
        BrokerMessage picture = BrokerMessage.json("picture", large, Quality.AT_LEAST_ONCE);
        for (int i = 0; i < 6; i++) {
            connection.publish(picture);
        }

        assertThatThrownBy(() -> connection.publish(state))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("too slow");
        connection.publish(BrokerMessage.json("stop", "{}", Quality.AT_LEAST_ONCE));
    }

    @Test
    void whatWasNotSentIsReportedAtTheEnd() throws InterruptedException {
        BlockingQueue<String> outcomes = new LinkedBlockingQueue<>();
        for (int i = 0; i < 3; i++) {
            connection.publish(
                    BrokerMessage.json("stop", "{}", Quality.AT_LEAST_ONCE),
                    problem -> outcomes.add(problem == null ? "acknowledged" : String.valueOf(problem.getMessage())));
        }
        connection.close();
        server.close();

        for (int i = 0; i < 3; i++) {
            assertThat(outcomes.poll(WaitLimit.SECONDS, TimeUnit.SECONDS))
                    .startsWith("the broker did not take the message on stop");
        }
    }

    @Test
    void itsThreadsAreDaemonsAndEndWithTheConnection() throws InterruptedException {
        BlockingQueue<Thread> callers = new LinkedBlockingQueue<>();
        connection.watch(new BrokerConnection.Watcher() {
            @Override
            public void connected() {
                callers.add(Thread.currentThread());
            }
        });
        Thread caller = callers.poll(WaitLimit.SECONDS, TimeUnit.SECONDS);
        assertThat(caller).isNotNull();
        assertThat(Thread.getAllStackTraces().keySet())
                .filteredOn(thread -> thread.getName().startsWith("MQTT"))
                .hasSizeGreaterThanOrEqualTo(2)
                .allMatch(Thread::isDaemon);
        connection.close();
        caller.join();

        assertThat(caller.isAlive()).isFalse();
    }
}
