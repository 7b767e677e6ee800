package majic.shared.broker;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;

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
