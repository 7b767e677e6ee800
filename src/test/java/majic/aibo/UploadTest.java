package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.verify;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.function.BiConsumer;
import majic.aibo.urbi.LinkTransport;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.bot.LinkLost;
import majic.driver.RobotWait;
import majic.link.Links;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Binaries to a server, also to one that goes away or takes no more in the middle of one. */
class UploadTest {

    private final BiConsumer<UrbiConnection, String> whenBroken = mock();
    private ServerSocket server;
    private UrbiConnection connection;
    private Socket peer;

    @BeforeEach
    void connect() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        connection = new UrbiConnection(
                "sensors",
                new LinkTransport(
                        Links.of("//127.0.0.1:" + server.getLocalPort(), AiboType.PORT, 0), TimeSource.system()),
                new RobotWait(TimeSource.system(), TimeSource.system().signal()),
                message -> {},
                whenBroken);
        connection.open(1000);
        peer = server.accept();
    }

    @AfterEach
    void close() throws IOException {
        connection.abort();
        peer.close();
        server.close();
    }

    @Test
    void commandsAndBinariesFollowEachOtherByteForByte() throws IOException {
        connection.send("a: 1;");
        connection.upload("speaker.val", "raw 1 8000 8 1", "ab;c".getBytes(StandardCharsets.US_ASCII));
        connection.upload("speaker.val", "raw 1 8000 8 1", new byte[0]);
        connection.send("b: 2;");

        String wire = "a: 1;\nspeaker.val = BIN 4 raw 1 8000 8 1;ab;cspeaker.val = BIN 0 raw 1 8000 8 1;b: 2;\n";
        assertThat(new String(peer.getInputStream().readNBytes(wire.length()), StandardCharsets.US_ASCII))
                .isEqualTo(wire);
    }

    @Test
    void aBinaryAboveTheLimitOfTheServerIsNotSent() throws IOException {
        byte[] tooMuch = new byte[UrbiConnection.LARGEST_BINARY + 1];

        assertThatThrownBy(() -> connection.upload("speaker.val", "raw 1 8000 8 1", tooMuch))
                .isInstanceOf(UrbiRefusal.class)
                .hasMessage("the dog takes 24576 bytes at once, not 24577");
        connection.send("c;");
        assertThat(peer.getInputStream().readNBytes(3)).isEqualTo("c;\n".getBytes(StandardCharsets.US_ASCII));
    }

    @Test
    void aBlockedWriteEndsTheConnectionAtItsDeadlineAndNothingFollowsThePartialBinary() {
        byte[] piece = new byte[UrbiConnection.LARGEST_BINARY];

        assertThatThrownBy(() -> {
                    for (int sent = 0; sent < 100_000; sent++) {
                        connection.upload("speaker.val", "raw 1 8000 8 1", piece);
                    }
                })
                .isInstanceOf(LinkLost.class)
                .hasMessageContaining("takes no more data");

        assertThatThrownBy(() -> connection.send("stop x;")).isInstanceOf(LinkLost.class);
        verify(whenBroken, timeout(WaitLimit.MS)).accept(any(), any());
    }

    @Test
    void aConnectionLostDuringAnUploadIsReported() throws IOException {
        peer.setSoLinger(true, 0);
        peer.close();

        assertThatThrownBy(() -> {
                    for (int sent = 0; sent < 1000; sent++) {
                        connection.upload("speaker.val", "raw 1 8000 8 1", new byte[1000]);
                    }
                })
                .isInstanceOf(LinkLost.class)
                .hasMessageStartingWith("connection lost: ");
    }
}
