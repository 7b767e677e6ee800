package majic.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class PortSearchTest {
    private static final InetAddress HERE = InetAddress.getLoopbackAddress();

    @AutoClose
    private final ServerSocket robot = new ServerSocket(0, 5, HERE);

    private final List<InetSocketAddress> found = new CopyOnWriteArrayList<>();
    private final CountDownLatch ended = new CountDownLatch(1);

    PortSearchTest() throws IOException {}

    private PortSearch search(Set<InetSocketAddress> spared) {
        List<Integer> ports = List.of(Loopback.freePort(), robot.getLocalPort());
        return new PortSearch(List.of(HERE), ports, spared, new PortSearch.Listener() {
            @Override
            public void found(InetSocketAddress place) {
                found.add(place);
            }

            @Override
            public void progress(int tried, int all) {
                if (tried == all) {
                    ended.countDown();
                }
            }
        });
    }

    private InetSocketAddress place() {
        return new InetSocketAddress(HERE, robot.getLocalPort());
    }

    @Test
    void findsTheHostsThatAcceptConnections() throws InterruptedException {
        try (PortSearch search = search(Set.of())) {
            search.start();
            ended.await();
            assertThat(found).containsExactly(place());
        }
    }

    @Test
    void sendsNothingAndClosesTheConnection() throws Exception {
        try (PortSearch search = search(Set.of())) {
            search.start();
            try (var connection = robot.accept()) {
                assertThat(connection.getInputStream().read()).isEqualTo(-1);
            }
        }
    }

    @Test
    void sparesTheRobotsOfTheTeam() throws InterruptedException {
        try (PortSearch search = search(Set.of(place()))) {
            search.start();
            ended.await();
            assertThat(found).isEmpty();
        }
    }

    @Test
    void aSearchOfNothingEndsAtOnce() throws InterruptedException {
        try (PortSearch search = new PortSearch(List.of(), List.of(1), Set.of(), new PortSearch.Listener() {
            @Override
            public void found(InetSocketAddress place) {}

            @Override
            public void progress(int tried, int all) {
                ended.countDown();
            }
        })) {
            search.start();
            ended.await();
        }
    }

    @Test
    void theNeighboursDifferInTheLastNumber() throws IOException {
        List<InetAddress> neighbours = PortSearch.neighbours(new byte[] {(byte) 192, (byte) 168, 1, (byte) 200});

        assertThat(neighbours).hasSize(253).doesNotContain(InetAddress.getByName("192.168.1.200"));
        assertThat(neighbours.get(0)).isEqualTo(InetAddress.getByName("192.168.1.1"));
        assertThat(PortSearch.networks(neighbours)).isEqualTo("192.168.1.x");
    }
}
