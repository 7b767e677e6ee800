package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The contract over connections to a real broker on this computer, which a relay cuts. */
abstract class RelayedContract extends BrokerContract {
    @AutoClose
    private RelayedConnections connections;

    /** The port of the broker, which has been started. */
    abstract int port();

    @BeforeEach
    void relay() {
        connections = new RelayedConnections(port());
    }

    @Test
    void anUrgentMessageDoesNotWaitForAHandlerThatBlocks() throws Exception {
        CountDownLatch blocked = new CountDownLatch(1);
        try (BrokerConnection sending = connected("sending", null);
                BrokerConnection receiving = connected("receiving", null)) {
            receiving.subscribe(topic("blocking"), Quality.AT_LEAST_ONCE, message -> awaitQuietly(blocked));
            receiving.subscribeUrgently(topic("+/urgent"), Quality.AT_LEAST_ONCE, arrived::add);
            sending.publish(message(topic("blocking"), "1"));
            sending.publish(message(topic("1/urgent"), "2"));

            assertThat(next().text()).isEqualTo("2");
        } finally {
            blocked.countDown();
        }
    }

    private static void awaitQuietly(CountDownLatch blocked) {
        try {
            blocked.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    BrokerConnection open(ConnectOptions options) {
        return connections.open(options);
    }

    @Override
    void cut(BrokerConnection connection) {
        connections.relay(connection).cut();
    }

    @Override
    void restore(BrokerConnection connection) {
        connections.relay(connection).restore();
    }
}
