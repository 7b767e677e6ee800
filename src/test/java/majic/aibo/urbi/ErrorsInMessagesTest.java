package majic.aibo.urbi;

import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.argThat;
import static org.mockito.ArgumentMatchers.eq;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.verify;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import majic.driver.ReplayLink;
import majic.driver.RobotWait;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;
import org.mockito.InOrder;

class ErrorsInMessagesTest {
    @Test
    void oneMessageThatCannotBeHandledDoesNotCostTheConnection() throws IOException {
        ReplayLink link = new ReplayLink(line("[1:a] 1.000000"), line("[2:b] 2.000000"), line("[3:c] 3.000000"));
        TimeSource time = TimeSource.system();
        Consumer<UrbiMessage> listener = mock();
        BiConsumer<UrbiConnection, String> whenBroken = mock();
        doThrow(new IllegalStateException("made up"))
                .doThrow(new LinkageError("made up"))
                .when(listener)
                .accept(any());

        new UrbiConnection(
                        "sensors",
                        new LinkTransport(link, time),
                        new RobotWait(time, time.signal()),
                        listener,
                        whenBroken)
                .open(1000);

        verify(whenBroken, timeout(WaitLimit.MS)).accept(any(), eq("the dog closed it"));
        InOrder order = inOrder(listener, whenBroken);
        for (String tag : List.of("a", "b", "c")) {
            order.verify(listener).accept(argThat(message -> message.tag().equals(tag)));
        }
        order.verify(whenBroken).accept(any(), any());
        order.verifyNoMoreInteractions();
    }

    private static byte[] line(String text) {
        return (text + "\n").getBytes(StandardCharsets.ISO_8859_1);
    }
}
