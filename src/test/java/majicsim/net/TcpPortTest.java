package majicsim.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.BindException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.world.Noise;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class TcpPortTest {
    private static final long MS = 1_000_000;

    private final EchoFirmware firmware = new EchoFirmware();
    private final ReentrantLock lock = new ReentrantLock(true);
    private final Faults faults = new Faults(Noise.seeded(1));

    @AutoClose
    private final TcpPort port = open(Clients.ONE);

    @Test
    void aClientIsGreetedAndAnswered() throws IOException {
        try (Client client = new Client(port.address())) {
            client.send("abc");
            assertThat(client.read(7)).isEqualTo("hi[abc]");
        }
    }

    @Test
    void countsAreTheClientsOwnOnceItHasItsAnswer() throws Exception {
        try (Client client = new Client(port.address())) {
            client.send("abc");
            client.read(7);
            awaitCount(new LineCount(port.address(), client.key(), 3, 7, true, false));
        }
    }

    @Test
    void aSecondClientIsTurnedAwayAndTheFirstStays() throws IOException {
        try (Client first = new Client(port.address());
                Client second = new Client(port.address())) {
            assertThat(first.read(2)).isEqualTo("hi");
            assertThat(second.readAll()).isEmpty();
            first.send("x");
            assertThat(first.read(3)).isEqualTo("[x]");
        }
    }

    @Test
    void aPortForManyServesTwoAtOnce() throws IOException {
        try (TcpPort many = open(Clients.MANY);
                Client first = new Client(many.address());
                Client second = new Client(many.address())) {
            second.send("2");
            first.send("1");
            assertThat(first.read(5)).isEqualTo("hi[1]");
            assertThat(second.read(5)).isEqualTo("hi[2]");
        }
    }

    @Test
    void aClientThatGoesIsReportedOnceAndTheNextOneIsServed() throws Exception {
        try (Client first = new Client(port.address())) {
            first.read(2);
        }
        awaitEvent("disconnected");
        try (Client second = new Client(port.address())) {
            assertThat(second.read(2)).isEqualTo("hi");
        }
        assertThat(port.lines()).hasSizeLessThan(2);
    }

    @Test
    void aFirmwareClosesTheLineAfterItsLastMessage() throws Exception {
        try (Client client = new Client(port.address())) {
            client.send("bye");
            assertThat(client.readAll()).isEqualTo("hi[bye]");
        }
        awaitEvent("disconnected");
    }

    @Test
    void aTakenPortIsRefused() {
        assertThatThrownBy(() -> TcpPort.open(port.number(), Clients.ONE, new Wiring(lock, firmware, faults)))
                .isInstanceOf(BindException.class);
    }

    @Test
    void aClientThatNeverReadsDelaysNoOther() throws Exception {
        byte[] flood = new byte[64 * 1024];
        try (Client client = new Client(port.address())) {
            client.send("x");
            awaitEvent("received x");
            lock.lock();
            Line line = firmware.last();
            for (int i = 0; i < 1000; i++) {
                line.send(flood);
            }
            lock.unlock();
            assertThat(port.lines().get(0).written()).isBetween(1_000_000L, 20_000_000L);
        }
        awaitEvent("disconnected");
    }

    @Test
    void aCutLineIsGoneForBothEnds() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            faults.cut();
            assertThatThrownBy(client::readAll).isInstanceOf(IOException.class);
        }
        awaitEvent("disconnected");
        assertThat(port.lines()).isEmpty();
    }

    @Test
    void anUnreachableRobotRefusesClientsAndComesBackAtTheSamePort() throws Exception {
        try (Client before = new Client(port.address())) {
            before.read(2);
            faults.unreachable();
            assertThatThrownBy(before::readAll).isInstanceOf(IOException.class);
        }
        assertThatThrownBy(() -> new Client(port.address())).isInstanceOf(ConnectException.class);

        faults.none();

        try (Client after = new Client(port.address())) {
            assertThat(after.read(2)).isEqualTo("hi");
        }
    }

    @Test
    void anUnreachableRobotKeepsItsPort() throws IOException {
        faults.unreachable();

        try (ServerSocket other = new ServerSocket()) {
            other.setReuseAddress(false);
            assertThatThrownBy(() -> other.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port.number())))
                    .isInstanceOf(BindException.class);
        }
    }

    @Test
    void aPortClosesWhileTheRobotIsUnreachable() throws IOException {
        TcpPort other = open(Clients.ONE);
        faults.unreachable();

        other.close();

        try (TcpPort again = TcpPort.open(other.number(), Clients.ONE, new Wiring(lock, firmware, faults))) {
            assertThat(again.number()).isEqualTo(other.number());
        }
    }

    @Test
    void delayedMessagesComeWhenTheLabGetsThere() throws Exception {
        faults.delay(10);
        try (Client client = new Client(port.address())) {
            awaitEvent("connected");
            client.send("a");
            awaitCount(new LineCount(port.address(), client.key(), 1, 0, true, false));
            step(10 * MS);
            assertThat(client.read(2)).isEqualTo("hi");
            step(20 * MS);
            assertThat(client.read(3)).isEqualTo("[a]");
        }
    }

    @Test
    void whatWasSentDuringAnOutageIsDeliveredAfterwards() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            faults.outage(2);
            client.send("late");
            step(1999 * MS);
            assertThat(port.lines().get(0).unread()).isTrue();
            assertThat(client.available()).isZero();
            step(2000 * MS);
            assertThat(client.read(6)).isEqualTo("[late]");
        }
    }

    @Test
    void anOutageShorterThanAStepEndsWithTheStep() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            faults.outage(0.001);
            client.send("late");
            assertThat(faults.isReading()).isFalse();
            step(4 * MS);
            assertThat(client.read(6)).isEqualTo("[late]");
        }
    }

    @Test
    void aPeerThatStopsReadingStillTalks() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            awaitCount(new LineCount(port.address(), client.key(), 0, 2, true, false));
            faults.stopReading();
            assertThat(port.lines()).extracting(LineCount::unread).containsExactly(true);
            client.send("unread");
            faults.none();
            assertThat(client.read(8)).isEqualTo("[unread]");
        }
    }

    @Test
    void halfPacketsArriveInTwoPieces() throws Exception {
        faults.halfPackets();
        try (Client client = new Client(port.address())) {
            assertThat(client.read(1)).isEqualTo("h");
            assertThat(client.available()).isZero();
            step(4 * MS);
            assertThat(client.read(1)).isEqualTo("i");
        }
    }

    @Test
    void garblingChangesBytesAndNeverTheirNumber() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            faults.garble(1);
            client.send("abcdefgh");
            assertThat(client.read(10)).hasSize(10).doesNotContain("abcdefgh");
        }
    }

    @Test
    void keptBytesAreDeliveredAfterTheClientDisconnected() throws Exception {
        try (Client client = new Client(port.address())) {
            client.read(2);
            faults.delay(10);
            client.send("stop");
            awaitCount(new LineCount(port.address(), client.key(), 4, 2, true, false));
        }
        step(10 * MS);
        awaitEvent("received stop");
        awaitEvent("disconnected");
    }

    @Test
    void aClientThatLeftMakesPlaceThoughItsLastBytesAreStillUnderWay() throws Exception {
        faults.delay(10);
        try (Client first = new Client(port.address())) {
            first.send("stop");
            awaitCount(new LineCount(port.address(), first.key(), 4, 0, true, false));
        }
        try (Client second = new Client(port.address())) {
            awaitEvent("received stop");
            awaitEvent("disconnected");
            awaitEvent("connected");
            step(10 * MS);
            assertThat(second.read(2)).isEqualTo("hi");
        }
    }

    private TcpPort open(Clients clients) {
        try {
            return TcpPort.open(0, clients, new Wiring(lock, firmware, faults));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private void step(long labNanos) {
        lock.lock();
        try {
            port.step(labNanos);
        } finally {
            lock.unlock();
        }
    }

    private void awaitEvent(String wanted) throws InterruptedException {
        String event = "";
        while (!wanted.equals(event)) {
            event = firmware.events.take();
        }
    }

    /** The counters are read without a lock, so the test looks until they have arrived; its time-out bounds it. */
    private void awaitCount(LineCount wanted) {
        while (!port.lines().equals(List.of(wanted))) {
            Thread.onSpinWait();
        }
    }
}
