package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Noise;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Clients on real sockets, good ones and bad ones, beside each other (URBI sheet, sections 2, 12 and 17). */
class ManyClientsTest {
    private final Bench bench = Bench.exact();
    private final ReentrantLock lock = new ReentrantLock();

    @AutoClose
    private TcpPort port;

    @BeforeEach
    void open() throws IOException {
        port = TcpPort.open(0, Clients.MANY, new Wiring(lock, bench.dog(), new Faults(Noise.exact())));
    }

    @Test
    void tenClientsAreEachAnsweredUnderTheirOwnTags() throws IOException {
        List<UrbiClient> clients = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            clients.add(connect());
        }
        for (int i = 0; i < 10; i++) {
            clients.get(i).send("x = " + i + "; t" + i + ": x;");
        }

        for (int i = 0; i < 10; i++) {
            assertThat(clients.get(i).await("t" + i)).isEqualTo(i + ".000000");
            clients.get(i).close();
        }
    }

    @Test
    void aCommandMayComeByteByByteAndManyMayComeAtOnce() throws IOException {
        try (UrbiClient client = connect()) {
            for (char each : "a: \"one; piece\";".toCharArray()) {
                client.send(String.valueOf(each));
            }
            assertThat(client.await("a")).isEqualTo("\"one; piece\"");

            client.send("b: 1; b: 2, b: 3 & b: 4 | b: 5;");
            for (int i = 1; i <= 5; i++) {
                assertThat(client.await("b")).isEqualTo(i + ".000000");
            }
        }
    }

    @Test
    void binariesGoBothWaysBetweenOtherMessages() throws IOException {
        try (UrbiClient client = connect()) {
            client.send(
                    "x = BIN 6 raw 1 8000 8 1;ab\n;\u00ff]y: 1; x: x; camera.format = 0; noop; noop; c: camera.val; z: 2;");

            assertThat(client.await("y")).isEqualTo("1.000000");
            assertThat(client.await("x")).isEqualTo("BIN 6 raw 1 8000 8 1\nab\n;\u00ff]");
            run(96);
            assertThat(client.await("c"))
                    .startsWith("BIN 99840 YCbCr 208 160 160\n")
                    .hasSize(28 + 99_840);
            assertThat(client.await("z")).isEqualTo("2.000000");
        }
    }

    @Test
    void aClientThatIsKilledWhileItsDogWalksStopsIt() throws IOException {
        UrbiClient client = connect();
        client.send("motors on; robot.walk(60s), go: 1;");
        client.await("go");
        run(1000);

        client.kill();

        await(() -> bench.dog().body().speedMmPerSec() == 0);
        assertThat(bench.dog().body().pose().xMm()).isLessThan(60 * 83.333);
    }

    @Test
    void aHalfClosedClientIsStillAnsweredAndThenClosed() throws IOException {
        try (UrbiClient client = connect();
                UrbiClient other = connect()) {
            client.send("a: 1;");
            client.endSending();

            assertThat(client.await("a")).isEqualTo("1.000000");
            assertThatThrownBy(client::next).isInstanceOf(EOFException.class);
            other.send("b: 2;");
            assertThat(other.await("b")).isEqualTo("2.000000");
        }
    }

    @Test
    void aClientThatStopsReadingDelaysNoOtherAndGetsAWarning() throws IOException {
        try (UrbiClient silent = connect();
                UrbiClient other = connect()) {
            silent.send("go: 1; s = \"0123456789\"; for (i = 0; i < 13; i++) s = s + s; f: loop s,");
            silent.await("go");
            run(20_000);
            other.send("a: 1;");
            assertThat(other.await("a")).isEqualTo("1.000000");

            other.send("stop f;");

            assertThat(silent.awaitAmong("error", () -> silent.send("1;"))).isEqualTo("!!! Send buffer full");
        }
    }

    @Test
    void aHundredClientsOneAfterTheOtherLeaveNothingBehind() throws IOException {
        for (int i = 0; i < 100; i++) {
            try (UrbiClient client = connect()) {
                client.send("x = 1; at (x > 5) echo \"late\", every(100) noop, y: x;");
                client.await("y");
            }
        }

        try (UrbiClient last = connect()) {
            while (connections(last) > 2) {
                Thread.onSpinWait();
            }
        }
    }

    /** How many the server counts, its own one among them. */
    private static int connections(UrbiClient client) throws IOException {
        client.send("connections; z: 1;");
        int count = 0;
        for (String tag = client.next().tag();
                !tag.equals("z");
                tag = client.next().tag()) {
            count += tag.equals("notag") ? 1 : 0;
        }
        return count;
    }

    private UrbiClient connect() throws IOException {
        UrbiClient client = new UrbiClient(port.number());
        client.await("ident");
        return client;
    }

    private void await(Condition condition) {
        while (!condition.holds()) {
            run(32);
            Thread.onSpinWait();
        }
    }

    private void run(double ms) {
        lock.lock();
        try {
            bench.run(ms);
        } finally {
            lock.unlock();
        }
    }

    private interface Condition {
        boolean holds();
    }
}
