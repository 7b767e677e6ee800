package majic.ros.websocket;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The request that turns a connection into a WebSocket, and its answer; the example of RFC 6455, 1.3. */
class UpgradeTest {
    private static final String KEY = "dGhlIHNhbXBsZSBub25jZQ==";
    private static final String ACCEPTED = "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
            + "Connection: Upgrade\r\nsec-websocket-accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n";

    private final Upgrade upgrade = new Upgrade("robot:9090", "/ws", KEY);

    @Test
    void theRequestNamesHostPathAndKey() {
        assertThat(new String(upgrade.request(), US_ASCII))
                .startsWith("GET /ws HTTP/1.1\r\nHost: robot:9090\r\n")
                .contains("\r\nSec-WebSocket-Key: " + KEY + "\r\n", "\r\nSec-WebSocket-Version: 13\r\n")
                .endsWith("\r\n\r\n");
    }

    @Test
    void theAnswerOfTheStandardIsAccepted() {
        assertThat(upgrade.refusal(ACCEPTED)).isNull();
    }

    @Test
    void anotherAnswerIsRefusedWithItsFirstLine() {
        assertThat(upgrade.refusal("HTTP/1.1 404 Not Found\r\nServer: nginx\r\n\r\n"))
                .isEqualTo("HTTP/1.1 404 Not Found");
        assertThat(upgrade.refusal(ACCEPTED.replace("s3pP", "xxxx"))).isEqualTo("HTTP/1.1 101 Switching Protocols");
        assertThat(upgrade.refusal(ACCEPTED.replace("101", "200"))).startsWith("HTTP/1.1 200");
        assertThat(upgrade.refusal("SSH-2.0-OpenSSH_9.2\r\n\r\n")).isEqualTo("SSH-2.0-OpenSSH_9.2");
    }
}
