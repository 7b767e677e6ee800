package majic.shared.broker;

import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuth;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import majic.bot.BotException;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;

/**
 * What a broker is shown, and what it has to show. The user name and the password are those that were typed, or else
 * come from the environment ({@code MAJIC_MQTT_USER}, {@code MAJIC_MQTT_PASSWORD}), or else from
 * {@code brokers.properties} in the user's folder, which also names the certificates.
 *
 * @param user null for none
 * @param password null for none
 * @param authority a PEM file with the certificate of the authority, or of the broker itself; null for those of Java
 * @param keyStore a PKCS 12 file with this client's certificate and key; null for none
 * @param keyStorePassword of that file; empty for none
 */
record BrokerCredentials(
        @Nullable String user,
        @Nullable String password,
        @Nullable Path authority,
        @Nullable Path keyStore,
        String keyStorePassword) {
    private static final String USER = "MAJIC_MQTT_USER";
    private static final String PASSWORD = "MAJIC_MQTT_PASSWORD";

    /**
     * Looks up the credentials for a broker.
     *
     * @throws BotException if the file can be read by others, or not be read
     */
    static BrokerCredentials find(BrokerAddress address, Settings settings) {
        return find(address, settings, System.getenv());
    }

    static BrokerCredentials find(BrokerAddress address, Settings settings, Map<String, String> environment) {
        Optional<CredentialsFile> file = settings.folder().flatMap(CredentialsFile::find);
        Properties entries = file.map(CredentialsFile::entries).orElseGet(Properties::new);
        String prefix = "broker." + address.host() + ".";
        Optional<BrokerLogins.Login> typed = BrokerLogins.find(address);
        String user = environment.getOrDefault(USER, entries.getProperty(prefix + "user"));
        String password =
                environment.containsKey(USER) ? environment.get(PASSWORD) : entries.getProperty(prefix + "password");
        return new BrokerCredentials(
                typed.map(BrokerLogins.Login::user).orElse(user),
                typed.map(BrokerLogins.Login::password).orElse(password),
                file.flatMap(one -> one.path(prefix + "ca")).orElse(null),
                file.flatMap(one -> one.path(prefix + "key-store")).orElse(null),
                entries.getProperty(prefix + "key-store-password", ""));
    }

    /** Returns the user name and the password as the client library takes them. */
    Optional<Mqtt5SimpleAuth> login() {
        if (user == null) {
            return Optional.empty();
        }
        var login = Mqtt5SimpleAuth.builder().username(user);
        return Optional.of(
                password == null
                        ? login.build()
                        : login.password(password.getBytes(StandardCharsets.UTF_8))
                                .build());
    }

    /** Says whose they are; never contains a password. */
    @Override
    public String toString() {
        return user == null ? "no user" : "user " + user;
    }
}
