package majic.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A stepped clock does not advance while a link counts as open, which is until its end has been handled. */
class LinkEndTest {
    private final CountDownLatch ended = new CountDownLatch(1);
    private final CountDownLatch mayTell = new CountDownLatch(1);
    private final Thread reader = new Thread(this::readToTheEnd);
    private ServerSocket server;
    private TcpLink link;

    @BeforeEach
    void connect() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        link = new TcpLink("127.0.0.1", server.getLocalPort());
        link.open(5000);
        reader.start();
    }

    @AfterEach
    void close() throws IOException {
        mayTell.countDown();
        link.close();
        server.close();
    }

    private void readToTheEnd() {
        try {
            assertThat(link.read(new byte[10])).isEqualTo(-1);
            link.close();
            ended.countDown();
            mayTell.await();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean counts() {
        return Links.traffic().stream()
                .anyMatch(traffic -> traffic.remote().equals("127.0.0.1:" + server.getLocalPort()));
    }

    @Test
    void aLinkClosedByThePeerCountsAsOpenUntilItsReaderHasHandledTheEnd() throws Exception {
        server.accept().close();
        ended.await();
        assertThat(counts()).isTrue();

        mayTell.countDown();
        reader.join();

        assertThat(counts()).isFalse();
    }

    @Test
    void aLinkClosedByItsOwnReaderCountsAsClosed() throws IOException {
        link.close();
        TcpLink mine = new TcpLink("127.0.0.1", server.getLocalPort());
        mine.open(5000);
        server.accept();
        server.accept().getOutputStream().write(1);
        assertThat(mine.read(new byte[10])).isEqualTo(1);

        mine.close();

        assertThat(counts()).isFalse();
    }

    @Test
    void aLinkClosedByAnotherThreadCountsAsClosed() {
        link.close();

        assertThat(counts()).isFalse();
    }
}
