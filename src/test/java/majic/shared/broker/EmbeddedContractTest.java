package majic.shared.broker;

import majic.shared.embedded.EmbeddedBroker;
import majic.shared.embedded.EmbeddedOptions;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.condition.EnabledIf;

/** The connections of this program to the embedded broker, whose libraries ./check fetches. */
@EnabledIf("isInstalled")
class EmbeddedContractTest extends BrokerContract {
    private static EmbeddedBroker broker;
    private static int port;

    @AutoClose
    private RelayedConnections connections;

    static boolean isInstalled() {
        return EmbeddedBroker.isInstalled();
    }

    @BeforeAll
    static void start() {
        port = Mosquitto.freePort();
        broker = EmbeddedBroker.start(EmbeddedOptions.loopback(port));
    }

    @AfterAll
    static void stop() {
        broker.close();
    }

    @BeforeEach
    void relay() {
        connections = new RelayedConnections(port);
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
