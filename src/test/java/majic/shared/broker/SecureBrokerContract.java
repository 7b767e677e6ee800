package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.environment.BotEnvironment;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests a broker with TLS that accepts the user anna with the password secret: which connections it accepts, and which
 * messages other users receive.
 */
abstract class SecureBrokerContract {
    static final String USER = "anna";
    static final String PASSWORD = "secret";

    private static final String TRUSTED = "broker.localhost.ca=listen.pem";
    private static final String NAME = "broker.localhost.user=" + USER;

    @TempDir
    private Path folder;

    /** The port of the running broker. */
    abstract int port();

    /** The certificate that the broker shows. */
    abstract Path certificate();

    private BrokerConnection open(String... lines) throws IOException {
        Files.copy(certificate(), folder.resolve("listen.pem"));
        BotEnvironment environment = WrittenCredentials.in(folder, lines).environment();
        return BrokerConnection.open(
                BrokerAddress.parse("mqtts://localhost:" + port() + "/test"),
                ConnectOptions.of("anna", environment).withTimeoutMs(WaitLimit.MS));
    }

    private ConnectFailed refusal(String... lines) throws IOException {
        try (BrokerConnection connection = open(lines)) {
            return catchThrowableOfType(ConnectFailed.class, connection::connect);
        }
    }

    @Test
    void aUserWithThePasswordIsAccepted() throws Exception {
        try (BrokerConnection connection = open(TRUSTED, NAME, "broker.localhost.password=" + PASSWORD)) {
            connection.connect();

            assertThat(connection.isConnected()).isTrue();
        }
    }

    @Test
    void aWrongPasswordIsRefused() throws IOException {
        ConnectFailed refusal = refusal(TRUSTED, NAME, "broker.localhost.password=guessed");

        assertThat(refusal.reason()).isEqualTo(Reason.WRONG_LOGIN);
        assertThat(refusal)
                .hasMessageContaining("the user name or the password")
                .hasMessageNotContaining("guessed");
    }

    @Test
    void aConnectionWithoutAUserIsRefused() throws IOException {
        assertThat(refusal(TRUSTED).reason()).isEqualTo(Reason.WRONG_LOGIN);
    }

    @Test
    void aBrokerThatThisComputerDoesNotKnowIsNotTrusted() throws IOException {
        ConnectFailed refusal = refusal(NAME, "broker.localhost.password=" + PASSWORD);

        assertThat(refusal.reason()).isEqualTo(Reason.OTHER);
        assertThat(refusal)
                .hasMessageContaining("no trusted TLS connection")
                .hasMessageContaining("broker.localhost.ca=FILE.pem");
    }
}
