package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

@Tag("jdk")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no pseudo-terminals that are serial ports")
class SerialLinkTest {
    private static final long SHORTER_THAN_A_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    /** One of so many reads is fast on a busy computer too. */
    private static final int MOST_ROUNDS = 1000;

    private final PseudoTerminal plug = new PseudoTerminal();
    private final SerialLink link = link(plug.name());
    private boolean pulled;

    private static SerialLink link(String name) {
        return new SerialLink(new SerialAddress(name, SerialPorts.system()), 115_200);
    }

    @BeforeEach
    void open() throws IOException {
        link.open(1000);
    }

    @AfterEach
    void close() {
        link.close();
        if (!pulled) {
            plug.close();
        }
    }

    @Test
    void carriesEveryByteUnchangedBothWays() throws IOException {
        link.write(new byte[] {'B', '\r'});
        assertThat(plug.read()).isEqualTo("B\r");

        plug.write("b\u0000\u0003\u0011\u0013\u00e9\r\n");
        assertThat(readText(8)).isEqualTo("b\u0000\u0003\u0011\u0013\u00e9\r\n");
    }

    @Test
    void bytesAreReturnedWhenTheyArriveWithoutATimeout() throws IOException {
        plug.write("x");
        readText(1);
        long shortest = Long.MAX_VALUE;
        for (int round = 0; round < MOST_ROUNDS && shortest >= SHORTER_THAN_A_TIMEOUT_NANOS; round++) {
            long start = System.nanoTime();
            plug.write("x");
            readText(1);
            shortest = Math.min(shortest, System.nanoTime() - start);
        }

        assertThat(shortest).isLessThan(SHORTER_THAN_A_TIMEOUT_NANOS);
    }

    @Test
    void closingWakesTheReader() throws Exception {
        CompletableFuture<Integer> reader = reader();

        link.close();

        assertThat(reader.get()).isEqualTo(-1);
    }

    @Test
    void anUnpluggedPortEndsTheReader() throws Exception {
        CompletableFuture<Integer> reader = reader();

        unplug();

        assertThat(reader.get()).isEqualTo(-1);
    }

    @Test
    void anUnpluggedPortRefusesToWrite() {
        unplug();

        assertThatThrownBy(() -> link.write(new byte[] {'B', '\r'})).isInstanceOf(IOException.class);
    }

    @Test
    void aBlockedPortIsClosedAtTheDeadline() {
        long start = System.nanoTime();

        assertThatThrownBy(() -> link.write(new byte[1_000_000]))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("takes no more data");

        assertThat(System.nanoTime() - start)
                .isGreaterThanOrEqualTo(TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS));
    }

    @Test
    void aSecondOpenReportsThatThisProgramUsesThePort() {
        SerialLink second = link(plug.name());

        assertThatThrownBy(() -> second.open(1000))
                .isInstanceOf(IOException.class)
                .hasMessage(
                        "this program uses the serial port " + plug.name() + " already; is a robot connected to it?");
    }

    @Test
    void aFailedSecondOpenLeavesTheFirstAlone() throws IOException {
        assertThatThrownBy(() -> link(plug.name()).open(1000)).isInstanceOf(IOException.class);

        link.write(new byte[] {'B', '\r'});

        assertThat(plug.read()).isEqualTo("B\r");
    }

    @Test
    void abortingDiscardsUndeliveredData() throws IOException {
        int queued = 6000;
        link.write(new byte[queued]);

        link.abort();

        assertThat(arrivesInAll()).isLessThan(queued);
    }

    /** A pseudo-terminal does not tell what is outstanding, and the library discards that when it closes a port. */
    @RepeatedTest(10)
    void whatWasWrittenRightBeforeClosingArrives() throws IOException {
        link.write("D,0,0\r".getBytes(StandardCharsets.US_ASCII));
        link.close();
        assertThat(arrivesInAll()).isEqualTo(6);
    }

    @Test
    void canBeOpenedAgainAfterClosing() throws IOException {
        link.close();
        SerialLink again = link(plug.name());
        again.open(1000);

        again.write(new byte[] {'I', '\r'});

        assertThat(plug.read()).isEqualTo("I\r");
        again.close();
    }

    @Test
    void aMissingPortIsNamed() {
        SerialLink none = link("/dev/ttyNONE7");

        assertThatThrownBy(() -> none.open(1000))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("/dev/ttyNONE7");
    }

    @Test
    void theTrafficIsCounted() throws IOException {
        link.write(new byte[] {'B', '\r'});
        plug.write("b\r\n");
        readText(3);

        assertThat(link.traffic().written()).isEqualTo(2);
        assertThat(link.traffic().remote()).isEqualTo(plug.name());
    }

    /** What the robot's side still receives from a port that was closed. */
    private int arrivesInAll() {
        int count = 0;
        try {
            while (true) {
                count += plug.read().length();
            }
        } catch (IOException e) {
            return count;
        }
    }

    private void unplug() {
        pulled = true;
        plug.close();
    }

    private CompletableFuture<Integer> reader() {
        return CompletableFuture.supplyAsync(() -> {
            try {
                return link.read(new byte[64]);
            } catch (IOException e) {
                return -2;
            }
        });
    }

    private String readText(int length) throws IOException {
        StringBuilder text = new StringBuilder();
        byte[] buffer = new byte[64];
        while (text.length() < length) {
            text.append(new String(buffer, 0, link.read(buffer), StandardCharsets.ISO_8859_1));
        }
        return text.toString();
    }
}
