package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.driver.ReplayLink;
import majic.driver.RobotWait;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class ErrorsInMessagesTest {
    private final List<String> tags = new CopyOnWriteArrayList<>();
    private final List<String> ends = new CopyOnWriteArrayList<>();
    private final CountDownLatch ended = new CountDownLatch(1);

    @Test
    void oneMessageThatCannotBeHandledDoesNotCostTheConnection() throws IOException, InterruptedException {
        ReplayLink link = new ReplayLink(line("[1:a] 1.000000"), line("[2:b] 2.000000"), line("[3:c] 3.000000"));
        TimeSource time = TimeSource.system();

        new UrbiConnection("sensors", new LinkTransport(link, time), new Failing(), new RobotWait(time, time.signal()))
                .open(1000);
        ended.await();

        assertThat(tags).containsExactly("a", "b", "c");
        assertThat(ends).containsExactly("the dog closed it");
    }

    private static byte[] line(String text) {
        return (text + "\n").getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Fails over every message. */
    private final class Failing implements UrbiConnection.Owner {
        @Override
        public void received(UrbiMessage message) {
            tags.add(message.tag());
            if (message.tag().equals("a")) {
                throw new IllegalStateException("made up");
            }
            throw new LinkageError("made up");
        }

        @Override
        public void broken(UrbiConnection connection, String why) {
            ends.add(why);
            ended.countDown();
        }
    }
}
