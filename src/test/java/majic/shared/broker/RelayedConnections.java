package majic.shared.broker;

import java.util.IdentityHashMap;
import java.util.Map;

/** Connections to a broker on this computer, each through a relay of its own. */
final class RelayedConnections implements AutoCloseable {
    private final Map<BrokerConnection, TcpRelay> relays = new IdentityHashMap<>();
    private final int port;

    RelayedConnections(int port) {
        this.port = port;
    }

    BrokerConnection open(ConnectOptions options) {
        TcpRelay relay = new TcpRelay(port);
        BrokerConnection connection =
                BrokerConnection.open(BrokerAddress.parse("mqtt://127.0.0.1:" + relay.port() + "/test"), options);
        relays.put(connection, relay);
        return connection;
    }

    TcpRelay relay(BrokerConnection connection) {
        return relays.get(connection);
    }

    @Override
    public void close() {
        relays.forEach((connection, relay) -> {
            connection.close();
            relay.close();
        });
    }
}
