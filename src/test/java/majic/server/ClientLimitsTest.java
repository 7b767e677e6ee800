package majic.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the limits of clients on a clock that advances only when a test advances it. */
class ClientLimitsTest {
    @TempDir
    private Path folder;

    private final AtomicLong nanos = new AtomicLong();

    @AutoClose
    private ServedClients clients;

    @BeforeEach
    void listen() throws IOException {
        InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        clients = new ServedClients(
                SocketFactory.getDefault(),
                robots -> LineServer.open(
                        any, robots.session, port -> ListenToken.create(folder, port), null, nanos::get));
    }

    private TestClient admitted() throws IOException {
        return clients.admitted();
    }

    private TestClient stranger() throws IOException {
        return clients.stranger();
    }

    private void pass(long amount, TimeUnit unit) {
        nanos.addAndGet(unit.toNanos(amount));
    }

    @Test
    void inOneSecondAClientGetsTwoHundredAnswersAndTheOthersLater() throws IOException {
        TestClient client = admitted().say("rubbish\n".repeat(LineClient.LINES_PER_SECOND + 1) + "close");
        for (int answer = 0; answer < LineClient.LINES_PER_SECOND; answer++) {
            assertThat(client.next()).contains("rubbish");
        }
        TestClient other = admitted().say("1 get x");
        assertThat(other.next()).isEqualTo("1 x = 0 mm");
        assertThat(client.hasAnswer()).isFalse();
        pass(1, TimeUnit.SECONDS);
        assertThat(client.untilItIsClosed()).hasSize(1);
    }

    @Test
    void stopsBeyondTwentyASecondWaitForTheirTurn() throws IOException {
        TestClient client = admitted().say("1 stop\n".repeat(LineClient.STOPS_PER_SECOND + 5) + "close");
        for (int answer = 0; answer < LineClient.STOPS_PER_SECOND; answer++) {
            assertThat(client.next()).isEqualTo("1 stop: done");
        }
        assertThat(admitted().say("1 get x").await("1 x")).isEqualTo("1 x = 0 mm");
        assertThat(client.hasAnswer()).isFalse();
        pass(1, TimeUnit.SECONDS);
        assertThat(client.untilItIsClosed()).hasSize(5);
    }

    @Test
    void aClientWithTooManyWaitingLinesIsClosedWithTheReason() throws IOException {
        TestClient client = admitted().sayRaw("1 get x\n".repeat(11_000));
        assertThat(client.untilItIsClosed()).last().asString().startsWith("closed: more than 10000 lines wait");
        assertThat(admitted().say("1 get x").next()).isEqualTo("1 x = 0 mm");
    }

    @Test
    void withoutATokenAConnectionEndsAfterTenSeconds() throws IOException {
        TestClient client = stranger();
        TestClient other = admitted().say("1 get x");
        assertThat(other.next()).isEqualTo("1 x = 0 mm");
        pass(11, TimeUnit.SECONDS);
        assertThat(client.untilItIsClosed()).first().isEqualTo("no token came within 10 s");
        assertThat(other.say("1 get x").next()).isEqualTo("1 x = 0 mm");
    }

    @Test
    void strangersTakeNoPlaceFromProgramsWithTheToken() throws IOException {
        TestClient first = stranger();
        for (int count = 0; count < 300; count++) {
            stranger();
        }
        assertThat(admitted().say("1 get x").next()).isEqualTo("1 x = 0 mm");
        assertThat(first.next()).isNull();
    }

    @Test
    void aProgramThatWasIdleForLongMakesRoomForAnother() throws IOException {
        TestClient idle = admitted().say("1 get x");
        idle.next();
        pass(5, TimeUnit.MINUTES);
        for (int count = 1; count < ClientPlaces.MOST_CLIENTS; count++) {
            admitted().say("1 get x").next();
        }
        assertThat(admitted().next()).startsWith("MAJIC has 64 clients already");
        pass(6, TimeUnit.MINUTES);
        assertThat(admitted().say("1 get x").next()).isEqualTo("1 x = 0 mm");
        assertThat(idle.untilItIsClosed())
                .containsExactly("closed: no line came for 10 minutes, and another program needs the place");
    }
}
