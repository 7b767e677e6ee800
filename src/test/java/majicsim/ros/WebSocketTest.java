package majicsim.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rules of RFC 6455, seen by a client that knows nothing of the simulator. */
class WebSocketTest {
    private static final byte[] CALL = bytes("{\"op\":\"call_service\",\"id\":\"t\",\"service\":\"/rosapi/get_time\"}");

    @AutoClose
    private RosStand stand;

    @BeforeEach
    void open() throws IOException {
        stand = new RosStand("2");
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Test
    void theHandshakeAnswersTheExampleOfTheStandard() throws IOException {
        try (RawWebSocket socket = new RawWebSocket(stand.address())) {
            assertThat(socket.request("/"))
                    .startsWith("HTTP/1.1 101 ")
                    .contains("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n");
        }
    }

    @Test
    void aBrowserIsAskedToUpgrade() throws IOException {
        try (RawWebSocket socket = new RawWebSocket(stand.address())) {
            socket.sendBytes(bytes("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
            assertThat(socket.readHead()).startsWith("HTTP/1.1 426 ");
        }
    }

    @Test
    void aRequestThatIsNoneIsRefused() throws IOException {
        try (RawWebSocket socket = new RawWebSocket(stand.address())) {
            socket.sendBytes(bytes("hello\r\n\r\n"));
            assertThat(socket.readHead()).startsWith("HTTP/1.1 400 ");
        }
    }

    @Test
    void onlyRos1AnswersAtAnyPath() throws IOException {
        try (RawWebSocket socket = new RawWebSocket(stand.address())) {
            assertThat(socket.request("/other")).startsWith("HTTP/1.1 404 ");
        }
        try (RosStand ros1 = new RosStand("1");
                RawWebSocket socket = new RawWebSocket(ros1.address())) {
            assertThat(socket.request("/other")).startsWith("HTTP/1.1 101 ");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64})
    void aMessageIsReadHoweverItsBytesArrive(int pieceSize) throws IOException {
        try (RawWebSocket socket = RawWebSocket.open(stand.address())) {
            byte[] frames = concat(
                    RawWebSocket.frame(RawWebSocket.PING, true, bytes("a")),
                    RawWebSocket.frame(RawWebSocket.TEXT, true, CALL),
                    RawWebSocket.frame(RawWebSocket.PING, true, bytes("b")));
            for (int i = 0; i < frames.length; i += pieceSize) {
                socket.sendBytes(Arrays.copyOfRange(frames, i, Math.min(frames.length, i + pieceSize)));
            }
            assertThat(socket.read().text()).isEqualTo("a");
            assertThat(socket.read().text()).contains("\"service_response\"");
            assertThat(socket.read().text()).isEqualTo("b");
        }
    }

    @Test
    void aMessageMayComeInFragmentsWithAPingBetweenThem() throws IOException {
        try (RawWebSocket socket = RawWebSocket.open(stand.address())) {
            socket.sendBytes(RawWebSocket.frame(RawWebSocket.TEXT, false, Arrays.copyOf(CALL, 10)));
            socket.sendBytes(RawWebSocket.frame(RawWebSocket.PING, true, bytes("between")));
            socket.sendBytes(RawWebSocket.frame(0, false, Arrays.copyOfRange(CALL, 10, 20)));
            socket.sendBytes(RawWebSocket.frame(0, true, Arrays.copyOfRange(CALL, 20, CALL.length)));
            RawWebSocket.Received pong = socket.read();
            assertThat(pong.opcode()).isEqualTo(RawWebSocket.PONG);
            assertThat(pong.text()).isEqualTo("between");
            assertThat(socket.read().text()).contains("\"service_response\"");
        }
    }

    @Test
    void aBinaryMessageWithTheSameJsonIsTaken() throws IOException {
        try (RawWebSocket socket = RawWebSocket.open(stand.address())) {
            socket.sendBytes(RawWebSocket.frame(RawWebSocket.BINARY, true, CALL));
            assertThat(socket.read().opcode()).isEqualTo(RawWebSocket.TEXT);
        }
    }

    @Test
    void aCloseIsAnsweredWithItsCodeAndEndsTheConnection() throws IOException {
        try (RawWebSocket socket = RawWebSocket.open(stand.address())) {
            socket.sendBytes(RawWebSocket.frame(RawWebSocket.CLOSE, true, new byte[] {3, (byte) 0xE9}));
            RawWebSocket.Received close = socket.read();
            assertThat(close.opcode()).isEqualTo(RawWebSocket.CLOSE);
            assertThat(close.closeCode()).isEqualTo(1001);
            assertThat(socket.isEnded()).isTrue();
        }
    }

    @Test
    void aFrameWithoutMaskIsAProtocolError() throws IOException {
        assertThat(closeCodeAfter(new byte[] {(byte) 0x81, 1, 'x'})).isEqualTo(1002);
    }

    @Test
    void aReservedOpcodeIsAProtocolError() throws IOException {
        assertThat(closeCodeAfter(RawWebSocket.frame(3, true, new byte[0]))).isEqualTo(1002);
    }

    @Test
    void aFragmentOutOfOrderIsAProtocolError() throws IOException {
        assertThat(closeCodeAfter(RawWebSocket.frame(0, true, CALL))).isEqualTo(1002);
    }

    @Test
    void aLongPingIsAProtocolError() throws IOException {
        assertThat(closeCodeAfter(RawWebSocket.frame(RawWebSocket.PING, true, new byte[126])))
                .isEqualTo(1002);
    }

    @Test
    void textThatIsNotUtf8ClosesTheConnection() throws IOException {
        assertThat(closeCodeAfter(RawWebSocket.frame(RawWebSocket.TEXT, true, new byte[] {(byte) 0xC3, 0x28})))
                .isEqualTo(1007);
    }

    @Test
    void ros2RefusesAMessageAboveTenMegabytesByItsLengthAlone() throws IOException {
        byte[] frame = RawWebSocket.frame(RawWebSocket.TEXT, true, new byte[10_000_001]);
        assertThat(closeCodeAfter(Arrays.copyOf(frame, 14))).isEqualTo(1009);
    }

    private int closeCodeAfter(byte[] bytes) throws IOException {
        try (RawWebSocket socket = RawWebSocket.open(stand.address())) {
            socket.sendBytes(bytes);
            RawWebSocket.Received close = socket.read();
            assertThat(close.opcode()).isEqualTo(RawWebSocket.CLOSE);
            return close.closeCode();
        }
    }

    private static byte[] concat(byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }
}
