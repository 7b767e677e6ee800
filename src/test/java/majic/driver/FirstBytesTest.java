package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FirstBytesTest {
    private static final String WEB_SERVER = "HTTP/1.1 400 Bad Request\r\nServer: nginx\r\n";
    private static final byte[] RFC_2217 = {(byte) 0xFF, (byte) 0xFB, 0x2C, (byte) 0xFF, (byte) 0xFB, 0x00};
    private static final byte[] SYNC0 = {(byte) 0xFA, (byte) 0xFB, 0x03, 0x00, 0x00, 0x00};

    private final FirstBytes words = new FirstBytes();

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 1000})
    void theFirstLineIsQuotedHoweverTheBytesArrive(int chunkSize) {
        byte[] wire = WEB_SERVER.getBytes(StandardCharsets.US_ASCII);
        for (int at = 0; at < wire.length; at += chunkSize) {
            receive(Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize)));
        }
        assertThat(words.line()).isEqualTo("HTTP/1.1 400 Bad Request");
    }

    @Test
    void decorationIsSkipped() {
        receive("[0:start] *** **********\r\n[0:start] *** URBI Kernel version 1.0\r\n"
                .getBytes(StandardCharsets.US_ASCII));
        assertThat(words.line()).isEqualTo("[0:start] *** URBI Kernel version 1.0");
    }

    @Test
    void aLongLineIsCut() {
        receive("x".repeat(500).getBytes(StandardCharsets.US_ASCII));
        assertThat(words.line()).hasSize(80);
    }

    @Test
    void packetsAreNoLine() {
        receive(SYNC0);
        assertThat(words.line()).isNull();
        assertThat(words.isEmpty()).isFalse();
    }

    @Test
    void nothingIsSilence() {
        assertThat(words.isEmpty()).isTrue();
        assertThat(words.line()).isNull();
    }

    @Test
    void aTelnetNegotiationIsRecognised() {
        receive(RFC_2217);
        assertThat(words.isTelnet()).isTrue();
    }

    @Test
    void aPacketIsNoTelnetNegotiation() {
        receive(SYNC0);
        assertThat(words.isTelnet()).isFalse();
    }

    @Test
    void telnetBytesBehindOthersAreNoNegotiation() {
        receive(new byte[] {'d', '\r', '\n', (byte) 0xFF, (byte) 0xFB});
        assertThat(words.isTelnet()).isFalse();
    }

    @Test
    void anAnswerOfAWebServerIsRecognised() {
        receive(WEB_SERVER.getBytes(StandardCharsets.US_ASCII));
        assertThat(words.isWebServer()).isTrue();
    }

    @Test
    void otherTextIsNoWebServers() {
        receive("Port already in use\r\n".getBytes(StandardCharsets.US_ASCII));
        assertThat(words.isWebServer()).isFalse();
    }

    private void receive(byte[] bytes) {
        words.received(bytes, bytes.length);
    }
}
