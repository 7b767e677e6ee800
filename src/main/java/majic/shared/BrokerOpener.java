package majic.shared;

import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;

/** Makes the connections to brokers; tests use one in memory. */
@FunctionalInterface
public interface BrokerOpener {
    /**
     * Makes a connection, which is not opened yet.
     *
     * @param address the broker
     * @param options name of the client, keep alive, clock
     * @return the connection, to be closed by the caller
     */
    BrokerConnection open(BrokerAddress address, ConnectOptions options);
}
