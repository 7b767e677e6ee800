package majic.shared.broker;

import java.util.Objects;
import majic.environment.BotEnvironment;
import org.jspecify.annotations.Nullable;

/**
 * How a connection to a broker is made. Immutable.
 *
 * @param clientId the name of this client, which no other client of the broker may have at the same time: the broker
 *     ends the connection of the older one
 * @param will the message that the broker publishes when the connection is lost without {@link BrokerConnection#close};
 *     null for none
 * @param keepAliveSeconds after one and a half times this without a sign of life the broker takes the connection for
 *     lost; at least 1
 * @param timeoutMs how long the broker may take to accept the connection, ms, at least 1; the first TLS connection of a
 *     program takes some seconds on a slow computer
 * @param environment the clock, and the settings, in whose folder the credentials are looked up
 */
public record ConnectOptions(
        String clientId,
        @Nullable BrokerMessage will,
        int keepAliveSeconds,
        int timeoutMs,
        BotEnvironment environment) {
    /** The keep alive of a client without a last will, s: it keeps its connection if it stalls for less than 3 s. */
    public static final int KEEP_ALIVE_SECONDS = 2;

    /** The keep alive of a client with a last will, s: others depend on the will, which is due after 1.5 s. */
    public static final int KEEP_ALIVE_WITH_WILL_SECONDS = 1;

    /** How long a broker may take unless another time is chosen, ms. */
    public static final int TIMEOUT_MS = 5_000;

    /**
     * Checks the parts.
     *
     * @throws IllegalArgumentException if the client has no name, the keep alive is below 1 s, or the timeout below 1
     *     ms
     */
    public ConnectOptions {
        Objects.requireNonNull(environment, "environment");
        if (clientId.isEmpty() || keepAliveSeconds < 1 || timeoutMs < 1) {
            throw new IllegalArgumentException(
                    "a client needs a name, a keep alive of 1 s and a timeout of 1 ms or more: " + clientId + ", "
                            + keepAliveSeconds + ", " + timeoutMs);
        }
    }

    /**
     * Options without a last will, with a keep alive of {@value #KEEP_ALIVE_SECONDS} s.
     *
     * @param clientId the name of this client
     * @param environment the clock and the settings
     * @return the options
     */
    public static ConnectOptions of(String clientId, BotEnvironment environment) {
        return new ConnectOptions(clientId, null, KEEP_ALIVE_SECONDS, TIMEOUT_MS, environment);
    }

    /**
     * Returns the same options with a last will, and a keep alive of {@value #KEEP_ALIVE_WITH_WILL_SECONDS} s.
     *
     * @param lastWill what the broker publishes when the connection is lost
     * @return the options
     */
    public ConnectOptions withWill(BrokerMessage lastWill) {
        return new ConnectOptions(clientId, lastWill, KEEP_ALIVE_WITH_WILL_SECONDS, timeoutMs, environment);
    }

    /**
     * Returns the same options with another keep alive.
     *
     * @param seconds at least 1
     * @return the options
     */
    public ConnectOptions withKeepAlive(int seconds) {
        return new ConnectOptions(clientId, will, seconds, timeoutMs, environment);
    }

    /**
     * Returns the same options with another timeout.
     *
     * @param ms at least 1
     * @return the options
     */
    public ConnectOptions withTimeoutMs(int ms) {
        return new ConnectOptions(clientId, will, keepAliveSeconds, ms, environment);
    }
}
