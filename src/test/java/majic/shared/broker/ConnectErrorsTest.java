package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.environment.BotEnvironment;
import majic.link.Loopback;
import majic.time.WaitLimit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What a user reads when a broker cannot be connected. */
class ConnectErrorsTest {
    /** CONNACK of MQTT 3.1.1: the protocol version is not supported. */
    private static final byte[] MQTT_3 = {0x20, 2, 0, 1};

    private static final byte[] HTTP =
            ("HTTP/1.1 400 Bad Request\r\n\r\n" + " ".repeat(100)).getBytes(StandardCharsets.US_ASCII);

    private static final byte NOT_AUTHORIZED = (byte) 0x87;
    private static final byte UNSUPPORTED_VERSION = (byte) 0x84;
    private static final byte BUSY = (byte) 0x89;

    private static ConnectFailed failure(String address) {
        return failure(address, WaitLimit.MS);
    }

    private static ConnectFailed failure(String address, int timeoutMs) {
        ConnectOptions options = ConnectOptions.of("a", BotEnvironment.plain()).withTimeoutMs(timeoutMs);
        try (BrokerConnection connection = BrokerConnection.open(BrokerAddress.parse(address), options)) {
            ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, connection::connect);
            assertThat(failure).hasMessageStartingWith(address + ": ");
            assertThat(connection.isConnected()).isFalse();
            return failure;
        }
    }

    private static ConnectFailed answered(String scheme, byte @Nullable [] answer) {
        try (ScriptedServer server = new ScriptedServer(answer)) {
            return failure(scheme + "://127.0.0.1:" + server.port() + "/lab");
        }
    }

    private static byte[] refusing(byte code) {
        return new byte[] {0x20, 3, 0, code, 0};
    }

    @Test
    void aPortAtWhichNothingListensIsNamed() {
        ConnectFailed failure = failure("mqtt://127.0.0.1:" + Loopback.freePort() + "/lab");

        assertThat(failure.reason()).isEqualTo(Reason.REFUSED);
    }

    @Test
    void anUnknownComputerIsNamed() {
        ConnectFailed failure = failure("mqtt://no-such-computer.invalid/lab");

        assertThat(failure.reason()).isIn(Reason.UNKNOWN_HOST, Reason.NO_ANSWER);
        assertThat(failure).hasMessageContaining("no-such-computer.invalid");
    }

    @Test
    void aServerThatSpeaksAnotherProtocolIsNoBroker() {
        ConnectFailed failure = answered("mqtt", HTTP);

        assertThat(failure.reason()).isEqualTo(Reason.WRONG_DEVICE);
        assertThat(failure).hasMessageContaining("MQTT 5");
    }

    @Test
    void aBrokerOfMqtt3IsTooOld() {
        assertThat(answered("mqtt", MQTT_3)).hasMessageContaining("MQTT 5");
        assertThat(answered("mqtt", refusing(UNSUPPORTED_VERSION))).hasMessageContaining("does not speak MQTT 5");
    }

    @Test
    void aRefusedUserLearnsWhereThePasswordIsWritten() {
        ConnectFailed failure = answered("mqtt", refusing(NOT_AUTHORIZED));

        assertThat(failure.reason()).isEqualTo(Reason.WRONG_LOGIN);
        assertThat(failure).hasMessageContaining("brokers.properties").hasMessageContaining("MAJIC_MQTT_USER");
    }

    @Test
    void aBusyBrokerIsToBeTriedAgain() {
        assertThat(answered("mqtt", refusing(BUSY)).reason()).isEqualTo(Reason.BUSY);
    }

    @Test
    void aServerThatHangsUpMayNeedTheOtherScheme() {
        assertThat(answered("mqtt", null)).hasMessageContaining("mqtts:// (with TLS)");
    }

    @Test
    void aServerThatSaysNothingDoesNotHangTheProgram() {
        try (ScriptedServer server = new ScriptedServer(new byte[0])) {
            ConnectFailed failure = failure("mqtt://127.0.0.1:" + server.port() + "/lab", ConnectOptions.TIMEOUT_MS);

            assertThat(failure.reason()).isEqualTo(Reason.NO_ANSWER);
        }
    }

    @Test
    void aPortWithoutTlsIsTold() {
        ConnectFailed failure = answered("mqtts", HTTP);

        assertThat(failure).hasMessageContaining("the port speaks no TLS");
    }
}
