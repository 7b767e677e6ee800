package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateEncodingException;
import java.util.Base64;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.environment.BotEnvironment;
import majic.link.Loopback;
import majic.server.ListenKey;
import majic.time.WaitLimit;
import majic.tool.KeyTool;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** A Mosquitto that accepts only clients with a certificate it trusts, where it is installed. */
@EnabledIf("isInstalled")
class ClientCertificateTest {
    private static final String KEY_STORE = "broker.localhost.key-store=";
    private static final String PASSWORD = "broker.localhost.key-store-password=";

    @TempDir
    private static Path folder;

    private static Path ofBroker;
    private static Path ofClient;
    private static Path expired;
    private static Mosquitto broker;

    @TempDir
    private Path home;

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    @BeforeAll
    static void start() throws Exception {
        ofBroker = Files.createDirectory(folder.resolve("broker"));
        ofClient = Files.createDirectory(folder.resolve("client"));
        ListenKey.create(ofBroker);
        ListenKey.create(ofClient);
        expired = folder.resolve("expired.p12");
        KeyStore old =
                KeyTool.make(expired, ListenKey.PASSWORD, "old", "CN=old", "-startdate", "-20d", "-validity", "10");
        broker = Mosquitto.start(
                folder,
                Loopback.freePort(),
                "allow_anonymous true",
                "certfile " + ofBroker.resolve(ListenKey.CERTIFICATE),
                "keyfile " + PemKey.write(ofBroker),
                "cafile " + trusted(old.getCertificate("old")),
                "require_certificate true");
    }

    private static Path trusted(Certificate old) throws IOException, CertificateEncodingException {
        String pem = "-----BEGIN CERTIFICATE-----\n" + Base64.getMimeEncoder().encodeToString(old.getEncoded())
                + "\n-----END CERTIFICATE-----\n";
        return Files.writeString(
                folder.resolve("trusted.pem"), Files.readString(ofClient.resolve(ListenKey.CERTIFICATE)) + pem);
    }

    @AfterAll
    static void stop() {
        if (broker != null) {
            broker.close();
        }
    }

    private BrokerConnection open(String keyStore, String password) throws IOException {
        BotEnvironment environment = WrittenCredentials.in(
                        home,
                        "broker.localhost.ca=" + ofBroker.resolve(ListenKey.CERTIFICATE),
                        keyStore,
                        PASSWORD + password)
                .environment();
        return BrokerConnection.open(
                BrokerAddress.parse("mqtts://localhost:" + broker.port() + "/test"),
                ConnectOptions.of("client", environment).withTimeoutMs(WaitLimit.MS));
    }

    private ConnectFailed refusal(String keyStore) throws IOException {
        try (BrokerConnection connection = open(keyStore, ListenKey.PASSWORD)) {
            return catchThrowableOfType(ConnectFailed.class, connection::connect);
        }
    }

    @Test
    void aClientWithATrustedCertificateIsAccepted() throws IOException {
        try (BrokerConnection connection = open(KEY_STORE + ofClient.resolve(ListenKey.FILE), ListenKey.PASSWORD)) {
            connection.connect();

            assertThat(connection.isConnected()).isTrue();
        }
    }

    @Test
    void withoutACertificateTheMessageNamesTheEntryThatIsMissing() throws IOException {
        ConnectFailed refusal = refusal("");

        assertThat(refusal.reason()).isEqualTo(Reason.OTHER);
        assertThat(refusal)
                .hasMessageContaining("requires a client certificate that it trusts, and none was found")
                .hasMessageContaining("broker.localhost.key-store=FILE.p12")
                .hasMessageNotContaining("broker.localhost.ca");
    }

    @Test
    void anotherCertificateIsRefusedAsNotTrusted() throws IOException {
        assertThat(refusal(KEY_STORE + ofBroker.resolve(ListenKey.FILE)))
                .hasMessageContaining("requires a client certificate that it trusts");
    }

    @Test
    void anExpiredCertificateIsRefusedWithThisReason() throws IOException {
        assertThat(refusal(KEY_STORE + expired))
                .hasMessageContaining("the client certificate has expired")
                .hasMessageContaining("broker.localhost.key-store=FILE.p12");
    }

    @Test
    void aKeyStoreThatCannotBeReadIsNamedWithTheReason() throws IOException {
        Path missing = home.resolve("missing.p12");
        try (BrokerConnection connection = open(KEY_STORE + missing, ListenKey.PASSWORD)) {
            assertThatThrownBy(connection::connect)
                    .isInstanceOf(BotException.class)
                    .hasMessage(missing + ", named in brokers.properties, cannot be read as a key store (PKCS 12) with"
                            + " this password: there is no such folder or file; is the entry right?");
        }
        try (BrokerConnection connection = open(KEY_STORE + ofClient.resolve(ListenKey.FILE), "guessed")) {
            assertThatThrownBy(connection::connect)
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining(ListenKey.FILE)
                    .hasMessageContaining("password")
                    .hasMessageNotContaining("guessed");
        }
    }
}
