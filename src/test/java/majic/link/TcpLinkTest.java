package majic.link;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class TcpLinkTest {
    @Test
    void aNameLookupWithoutAnswerIsGivenUpInTime() {
        CountDownLatch answered = new CountDownLatch(1);
        TcpLink link = new TcpLink("robot.example", 8101, new TcpConnector("robot.example", 8101, host -> {
            await(answered);
            return InetAddress.getLoopbackAddress();
        }));

        assertThatThrownBy(() -> link.open(200))
                .hasMessage("the name robot.example was not found within 0.2 s; use its IP address");
        answered.countDown();
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void anUnknownNameIsReportedAsUnknown() {
        assertThatThrownBy(() -> new TcpLink("no-such-robot.invalid", 8101).open(5000))
                .hasMessage(
                        "there is no computer named no-such-robot.invalid; is the name right, or does its IP address do?");
    }

    @Test
    void aLinkThatWasClosedDoesNotOpenAnyMore() throws IOException {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            TcpLink link = new TcpLink("127.0.0.1", server.getLocalPort());
            link.close();

            assertThatThrownBy(() -> link.open(1000)).hasMessage("closed while connecting");
        }
    }
}
