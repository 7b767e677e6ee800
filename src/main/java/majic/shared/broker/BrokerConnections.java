package majic.shared.broker;

import majic.bot.BotException;

/** Opens connections to brokers. */
public final class BrokerConnections {
    private static final String CLIENT = "com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient";

    private BrokerConnections() {}

    /**
     * Creates a connection, which is made by {@link BrokerConnection#connect}.
     *
     * @param address of the broker
     * @param options name of this client, last will and keep alive
     * @return the connection; its threads are daemons and end with {@link BrokerConnection#close}
     * @throws BotException if the library is missing; the message names it
     */
    public static BrokerConnection open(BrokerAddress address, ConnectOptions options) {
        requireLibrary();
        return new HiveConnection(address, options);
    }

    private static void requireLibrary() {
        try {
            Class.forName(CLIENT, false, BrokerConnections.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new BotException("shared robots need the library hivemq-mqtt-client: add it to the class path", e);
        }
    }
}
