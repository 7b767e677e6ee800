package majicsim.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fazecast.jSerialComm.SerialPort;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.world.Noise;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PtyPortTest {
    private final EchoFirmware firmware = new EchoFirmware();
    private final Faults faults = new Faults(Noise.exact());
    private final Optional<PtyPort> opened = PtyPort.open(new Wiring(new ReentrantLock(true), firmware, faults));

    @BeforeEach
    void needsPseudoTerminals() {
        assumeTrue(opened.isPresent(), "no pseudo-terminals here");
    }

    @AfterEach
    void close() {
        opened.ifPresent(PtyPort::close);
    }

    @Test
    void bytesPassUnchangedInBothDirections() throws IOException {
        String awkward = "\0\r\n\u0003\u0004\u0011\u0013\u007f\u00ff";
        assertThat(exchange(awkward, 2 + awkward.length() + 2)).isEqualTo("hi[" + awkward + "]");
    }

    @Test
    void clientsComeAndGo() throws IOException {
        exchange("a", 5);
        assertThat(exchange("b", 3)).isEqualTo("[b]");
        assertThat(exchange("c", 3)).isEqualTo("[c]");
        assertThat(firmware.events).doesNotContain("disconnected");
    }

    @ParameterizedTest
    @ValueSource(ints = {9600, 19_200, 38_400, 57_600, 115_200})
    void theClientsSpeedIsSeen(int baud) {
        SerialPort client = SerialPort.getCommPort(opened.orElseThrow().address());
        client.setBaudRate(baud);
        assertThat(client.openPort()).isTrue();
        assertThat(firmware.last().baud()).isEqualTo(baud);
        client.closePort();
    }

    @Test
    void countsAreKeptUnderTheDevicesPath() throws IOException {
        exchange("abc", 7);
        LineCount wanted = new LineCount(
                opened.orElseThrow().address(), opened.orElseThrow().address(), 3, 7, true, false);
        while (!opened.orElseThrow().lines().contains(wanted)) {
            Thread.onSpinWait();
        }
    }

    @Test
    void unreadBytesAreLostAndDelayNoOther() throws IOException {
        exchange("a", 5);
        for (int i = 0; i < 100; i++) {
            firmware.last().send(new byte[1000]);
        }
        assertThat(opened.orElseThrow().lines().get(0).written()).isBetween(1000L, 99_000L);
    }

    @Test
    void aStoppedPeerReadsOnLater() throws IOException {
        exchange("a", 5);
        faults.stopReading();
        try (FileOutputStream out = new FileOutputStream(opened.orElseThrow().address())) {
            out.write('b');
        }
        faults.none();
        assertThat(exchange("", 3)).isEqualTo("[b]");
    }

    @Test
    void anUnreachableRobotLosesWhatItIsSent() throws IOException {
        exchange("a", 5);
        faults.unreachable();
        try (FileOutputStream out = new FileOutputStream(opened.orElseThrow().address())) {
            out.write('b');
        }
        while (opened.orElseThrow().lines().get(0).consumed() < 2) {
            Thread.onSpinWait();
        }

        faults.none();

        assertThat(exchange("c", 3)).isEqualTo("[c]");
    }

    @Test
    void closingEndsTheLine() {
        opened.orElseThrow().close();
        assertThat(firmware.events).endsWith("disconnected");
        assertThat(opened.orElseThrow().lines()).isEmpty();
    }

    private String exchange(String text, int replyLength) throws IOException {
        String path = opened.orElseThrow().address();
        try (FileInputStream in = new FileInputStream(path);
                FileOutputStream out = new FileOutputStream(path)) {
            out.write(text.getBytes(StandardCharsets.ISO_8859_1));
            StringBuilder reply = new StringBuilder();
            while (reply.length() < replyLength) {
                reply.append((char) in.read());
            }
            return reply.toString();
        }
    }
}
