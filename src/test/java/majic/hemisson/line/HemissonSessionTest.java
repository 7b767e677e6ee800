package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.driver.ReplayLink;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** One connection and its reader thread. */
@Timeout(20)
class HemissonSessionTest {
    @Test
    void anErrorInOneLineDoesNotEndTheLink() throws InterruptedException {
        CountDownLatch ended = new CountDownLatch(1);
        List<String> resets = new CopyOnWriteArrayList<>();
        byte[] greeting = "HemiOS V1.50\r\n".getBytes(StandardCharsets.ISO_8859_1);

        HemissonSession session = new HemissonSession(
                new ReplayLink(greeting, greeting), TimeSource.system(), new ConversationListener() {
                    @Override
                    public void answered(Exchange exchange) {}

                    @Override
                    public void missed(Exchange exchange, boolean inMotion) {}

                    @Override
                    public void wasReset() {
                        resets.add("reset");
                        throw new LinkageError("made up");
                    }

                    @Override
                    public void broken(IOException cause) {
                        ended.countDown();
                    }
                });
        session.start();
        ended.await();

        assertThat(resets).hasSize(2);
    }
}
