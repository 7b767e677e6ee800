package majic.shared.embedded;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * How the embedded broker is started. Immutable.
 *
 * @param address where it listens
 * @param keyStore a PKCS 12 file with the certificate and the key; null for no TLS
 * @param keyStorePassword of that file, and of the key in it; empty without one
 * @param user the only user that may connect; null if every user may
 * @param password of the user; null without one
 */
public record EmbeddedOptions(
        InetSocketAddress address,
        @Nullable Path keyStore,
        String keyStorePassword,
        @Nullable String user,
        @Nullable String password) {
    /**
     * Refuses a broker that is open to the network.
     *
     * @throws BotException if other computers could connect without TLS or without a password
     */
    public EmbeddedOptions {
        if (address.isUnresolved()) {
            throw new BotException(address.getHostString() + ": not an address of this computer");
        }
        boolean protectedByPassword = user != null && password != null && !password.isEmpty();
        if (!address.getAddress().isLoopbackAddress() && (keyStore == null || !protectedByPassword)) {
            throw new BotException("a broker at " + address.getHostString()
                    + " can be reached by other computers, so it needs a user and a password: set MAJIC_MQTT_USER and"
                    + " MAJIC_MQTT_PASSWORD; without them it runs at 127.0.0.1 alone");
        }
    }

    /**
     * Options for programs of this computer alone.
     *
     * @param port the TCP port
     * @return a broker at 127.0.0.1 without TLS and without a password
     */
    public static EmbeddedOptions loopback(int port) {
        return new EmbeddedOptions(new InetSocketAddress("127.0.0.1", port), null, "", null, null);
    }

    /** Names the address; never contains a password. */
    @Override
    public String toString() {
        return (keyStore == null ? "mqtt://" : "mqtts://") + address.getHostString() + ":" + address.getPort();
    }
}
