package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyInt;
import static org.mockito.ArgumentMatchers.assertArg;
import static org.mockito.Mockito.doAnswer;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.verify;

import java.io.IOException;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import majic.link.Link;
import majic.time.WaitLimit;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.mockito.InOrder;

/** The effect of errors in a reader on its link. */
class LinkReaderTest {
    private final LinkHandler<String> handler = mock();

    @BeforeEach
    void takeEachChunkAsOneMessage() {
        doAnswer(call -> {
                    byte[] bytes = call.getArgument(0);
                    int count = call.getArgument(1);
                    Consumer<String> messages = call.getArgument(2);
                    messages.accept(new String(bytes, 0, count, StandardCharsets.US_ASCII));
                    return null;
                })
                .when(handler)
                .decode(any(), anyInt(), any());
    }

    @Test
    void everyMessageIsReceivedAndThenTheEnd() {
        readUntil("the robot closed it");

        assertReceivesAllInOrder();
    }

    @Test
    void anErrorOverOneMessageIsLoggedAndTheNextMessageIsReceived() {
        doThrow(new IllegalStateException("a report that was misread"))
                .when(handler)
                .received("a");
        doThrow(new StackOverflowError()).when(handler).received("b");

        readUntil("the robot closed it");

        assertReceivesAllInOrder();
    }

    @Test
    void anErrorInDecodingEndsTheLink() {
        doThrow(new OutOfMemoryError("made up")).when(handler).decode(any(), anyInt(), any());

        readUntil("an error in MAJIC, see its log");

        verify(handler, never()).received(any());
    }

    @Test
    void aHandlerRunsWithoutPermissionToWait() {
        List<Boolean> mayWait = new CopyOnWriteArrayList<>();
        doAnswer(call -> mayWait.add(WaitPolicy.isAllowed())).when(handler).received(any());

        readUntil("the robot closed it");

        assertThat(mayWait).containsExactly(false, false, false);
    }

    @Test
    void aResetOfTheConnectionIsNamedInPlainWords() throws IOException {
        Link link = mock();
        doThrow(new SocketException("Connection reset")).when(link).read(any());

        readUntil("the other end reset it", link);
    }

    private void readUntil(String end) {
        readUntil(end, new ReplayLink(new byte[] {'a'}, new byte[] {'b'}, new byte[] {'c'}));
    }

    private void readUntil(String end, Link link) {
        new LinkReader<>(link, "the robot closed it", handler).start("test reader");
        verify(handler, timeout(WaitLimit.MS))
                .ended(assertArg(cause -> assertThat(cause).hasMessage(end)));
    }

    private void assertReceivesAllInOrder() {
        InOrder order = inOrder(handler);
        for (String message : List.of("a", "b", "c")) {
            order.verify(handler).received(message);
        }
        order.verify(handler).ended(any());
        order.verifyNoMoreInteractions();
    }
}
