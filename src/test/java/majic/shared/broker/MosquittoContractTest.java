package majic.shared.broker;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The connections of this program to Mosquitto, where it is installed. */
@EnabledIf("isInstalled")
class MosquittoContractTest extends BrokerContract {
    @TempDir
    private static Path folder;

    private static Mosquitto broker;

    @AutoClose
    private RelayedConnections connections;

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    @BeforeAll
    static void start() {
        broker = Mosquitto.start(folder);
    }

    @AfterAll
    static void stop() {
        broker.close();
    }

    @BeforeEach
    void relay() {
        connections = new RelayedConnections(broker.port());
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
