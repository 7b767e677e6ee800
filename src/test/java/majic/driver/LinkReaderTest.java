package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The effect of errors in a reader on its link. */
@Timeout(20)
class LinkReaderTest {
    private final List<String> received = new CopyOnWriteArrayList<>();
    private final List<String> ends = new CopyOnWriteArrayList<>();
    private final CountDownLatch ended = new CountDownLatch(1);

    /** Each chunk is one message. */
    private class Chunks implements LinkHandler<String> {
        @Override
        public void decode(byte[] bytes, int count, Consumer<String> messages) {
            messages.accept(new String(bytes, 0, count, StandardCharsets.US_ASCII));
        }

        @Override
        public void received(String message) {
            received.add(message);
        }

        @Override
        public void ended(IOException cause) {
            ends.add(cause.getMessage());
            ended.countDown();
        }
    }

    @Test
    void everyMessageIsReceivedAndThenTheEnd() throws InterruptedException {
        read(new Chunks());

        assertThat(received).containsExactly("a", "b", "c");
        assertThat(ends).containsExactly("the robot closed it");
    }

    @Test
    void anErrorOverOneMessageIsLoggedAndTheNextMessageIsReceived() throws InterruptedException {
        read(new Chunks() {
            @Override
            public void received(String message) {
                switch (message) {
                    case "a" -> throw new IllegalStateException("a report that was misread");
                    case "b" -> throw new StackOverflowError();
                    default -> super.received(message);
                }
            }
        });

        assertThat(received).containsExactly("c");
        assertThat(ends).containsExactly("the robot closed it");
    }

    @Test
    void anErrorInDecodingEndsTheLink() throws InterruptedException {
        read(new Chunks() {
            @Override
            public void decode(byte[] bytes, int count, Consumer<String> messages) {
                throw new OutOfMemoryError("made up");
            }
        });

        assertThat(received).isEmpty();
        assertThat(ends).containsExactly("an error in MAJIC, see its log");
    }

    @Test
    void aHandlerRunsWithoutPermissionToWait() throws InterruptedException {
        List<Boolean> mayWait = new CopyOnWriteArrayList<>();
        read(new Chunks() {
            @Override
            public void received(String message) {
                mayWait.add(WaitPolicy.isAllowed());
            }
        });

        assertThat(mayWait).containsExactly(false, false, false);
    }

    private void read(LinkHandler<String> handler) throws InterruptedException {
        ReplayLink link = new ReplayLink(new byte[] {'a'}, new byte[] {'b'}, new byte[] {'c'});
        new LinkReader<>(link, "the robot closed it", handler).start("test reader");
        ended.await();
    }
}
