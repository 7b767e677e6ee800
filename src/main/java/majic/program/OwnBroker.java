package majic.program;

import java.io.IOException;
import java.net.InetSocketAddress;
import majic.server.ListenKey;
import majic.shared.embedded.EmbeddedBroker;
import majic.shared.embedded.EmbeddedOptions;

/** The embedded broker as the command line requests it. Beyond this computer it uses the key of {@code --listen}. */
final class OwnBroker implements AutoCloseable {
    private static final String USER = "MAJIC_MQTT_USER";
    private static final String PASSWORD = "MAJIC_MQTT_PASSWORD";

    private final EmbeddedBroker broker;

    private OwnBroker(EmbeddedBroker broker) {
        this.broker = broker;
    }

    /**
     * Starts a broker. Blocks for some seconds.
     *
     * @throws majic.bot.BotException if it cannot be started, or would be open to other computers without a password
     * @throws IOException if there is no key for TLS
     */
    static OwnBroker start(InetSocketAddress address, UserFolder folder) throws IOException {
        String user = System.getenv(USER);
        String password = System.getenv(PASSWORD);
        boolean withUser = user != null && !user.isEmpty();
        if (address.isUnresolved() || address.getAddress().isLoopbackAddress() || !withUser) {
            return new OwnBroker(EmbeddedBroker.start(
                    new EmbeddedOptions(address, null, "", withUser ? user : null, withUser ? password : null)));
        }
        ListenKey key = ListenKey.in(folder.path());
        return new OwnBroker(
                EmbeddedBroker.start(new EmbeddedOptions(address, key.file(), ListenKey.PASSWORD, user, password)));
    }

    @Override
    public void close() {
        broker.close();
    }
}
